template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    if (task == 3) {
        const int form = static_cast<int>(in.number());
        Surface s{};
        s.ior = in.uniform();
        s.k = in.uniform();
        s.F0 = in.uniform();
        s.dip = in.uniform();
        out(reflectance(static_cast<Fresnel>(form), s, in.number()));
    }
    if constexpr (std::same_as<T, double>) {
        if (task == 1) {
            const double radiance = in.number();
            out(code_error(radiance, in.number()));
        } else if (task == 2) {
            std::array<Method, 4> methods{};
            for (Method& m : methods) {
                m.ns = in.number();
                m.error = in.number();
            }
            out(static_cast<double>(cheapest(methods, in.number())));
        }
    }
}
