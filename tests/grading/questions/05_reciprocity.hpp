template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Incidence<T> g = in.incidence();
    if (task == 1) {
        const Incidence<T> other = swapped(g);
        out(Vec3<T>(other.NL, other.NV, other.LV));
    } else if (task == 2) {
        const ClassicPhong brdf{.n = in.uniform_number()};
        out(brdf(g).r);
    }
}
