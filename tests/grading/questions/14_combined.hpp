template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Rgb<T> F0 = in.vector();
    if (task == 3) {
        const Incidence<T> g = in.incidence();
        out(specular_by_angle(F0, in.number(), g));
        return;
    }
    const Rgb<T> Cd = in.vector();
    if (task == 1) {
        out(diffuse_by_angle(Cd, F0, in.incidence()));
    } else if (task == 2) {
        out(diffuse_by_f0(Cd, F0));
    }
}
