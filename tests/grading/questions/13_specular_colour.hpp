template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Rgb<float> colour = in.uniform();
    if (task == 1) {
        out(diffuse_albedo(colour, in.number() > T(0.5F)));
    } else if (task == 2) {
        out(f0_from_srgb(colour));
    }
}
