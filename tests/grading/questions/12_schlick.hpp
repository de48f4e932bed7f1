template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const T x = in.number();
    if (task == 1) {
        out(f0_dielectric(x));
    } else if (task == 2) {
        out(f0_conductor(x, in.number()));
    } else if (task == 3) {
        out(schlick_weight(x));
    }
}
