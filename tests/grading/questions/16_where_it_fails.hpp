template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Rgb<T> F0 = in.vector();
    if (task == 1) {
        const Rgb<T> Cd = in.vector();
        out(coupled_diffuse(Cd, F0, in.incidence()));
    } else if (task == 2) {
        const Incidence<T> g = in.incidence();
        out(reciprocal_specular(F0, in.number(), g));
    }
}
