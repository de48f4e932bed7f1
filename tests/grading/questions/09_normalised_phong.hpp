template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    if (task == 1) {
        out(phong_normalisation(in.number()));
    } else if (task == 2) {
        const Incidence<T> g = in.incidence();
        out(normalised_phong(g, in.number()));
    }
}
