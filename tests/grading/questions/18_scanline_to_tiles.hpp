inline glm::ivec2 corner(In<double>& in, int scale) {
    const auto x = static_cast<int>(in.number());
    return glm::ivec2(x, static_cast<int>(in.number())) * scale;
}

template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    if constexpr (std::same_as<T, double>) {
        if (task == 1) {
            const auto pixels = static_cast<float>(in.number());
            out(by_hand::snapped(pixels, static_cast<int>(in.number())));
            return;
        }
        const int scale = task == 3 ? 256 : 1;
        const glm::ivec2 p = corner(in, scale);
        const glm::ivec2 q = corner(in, scale);
        const glm::ivec2 r = corner(in, scale);
        if (task == 2) {
            const by_hand::EdgeFunction e = by_hand::edge_function(p, q);
            out(static_cast<double>(e.at(r.x, r.y)));
            out(static_cast<double>(e.at(p.x, p.y)));
            out(static_cast<double>(e.at(q.x, q.y)));
        } else if (task == 3) {
            const glm::ivec2 at = corner(in, scale);
            bool covers = true;
            for (const by_hand::EdgeFunction& e : by_hand::set_up({p, q, r})) {
                covers = covers && e.at(at.x, at.y) >= 0;
            }
            out(covers ? 1 : 0);
        } else if (task == 4) {
            const glm::ivec2 first = corner(in, 1);
            const auto edges = by_hand::set_up({p, q, r});
            const auto bits = lane_bits(by_hand::covered<Int<4>>(edges, first.x, first.y));
            for (int lane = 0; lane < 4; ++lane) {
                out(bits >> lane & 1);
            }
        }
    }
}
