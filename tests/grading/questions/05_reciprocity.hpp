template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Incidence<T> g = in.incidence();
    if (task == 1) {
        const Incidence<T> other = swapped(g);
        out(Vec3<T>(other.NL, other.NV, other.LV));
    } else if (task == 2) {
        const ClassicPhong brdf{.n = static_cast<float>(in.number())};
        out(brdf(g).r);
    }
}
