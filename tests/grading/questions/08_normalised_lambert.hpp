template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const NormalisedLambert brdf{.Cd = in.uniform()};
    if (task == 1) {
        out(brdf(in.incidence()));
    } else if (task == 2) {
        out(brdf.ambient_albedo());
    }
}
