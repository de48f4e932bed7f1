template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Vec3<T> N = in.vector();
    const Vec3<T> L = in.vector();
    if (task == 1) {
        out(matt_shading(N, L));
    } else if (task == 2) {
        out(mirrored(N, L));
    } else if (task == 3) {
        const Vec3<T> V = in.vector();
        out(highlight(N, L, V, in.number()));
    }
}
