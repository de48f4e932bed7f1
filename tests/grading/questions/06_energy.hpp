template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const auto a = static_cast<double>(in.number());
    if (task == 2) {
        out(static_cast<T>(phong_albedo_along_normal(a)));
        return;
    }
    const auto b = static_cast<double>(in.number());
    const auto brdf = [&](const Incidence<double>& g) {  // grows towards grazing light
        return Rgb<double>(a + b * (1 - g.NL) * (1 - g.NL) + 0.1 * b * g.NV);
    };
    if (task == 1) {
        out(static_cast<T>(albedo(brdf, static_cast<double>(in.number()), 12)));
    } else if (task == 3) {
        out(conserves_energy(brdf, 8) ? T(1.0F) : T(0.0F));
    }
}
