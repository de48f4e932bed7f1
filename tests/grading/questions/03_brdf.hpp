template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    if (task == 1) {
        out(lambert_unnormalised(in.uniform()));
    } else if (task == 2) {
        const Incidence<T> g = in.incidence();
        out(phong_lobe(g, in.number()));
    } else if (task == 3) {
        const Rgb<T> brdf = in.vector();
        const Rgb<T> E = in.vector();
        out(reflect_light(brdf, E, in.number()));
    }
}
