template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const T ior = in.number();
    const T k = in.number();
    const T cosine = in.number();
    const Reflectances<T> R = task == 1 ? fresnel_conductor(ior, k, cosine)
                                        : fresnel_conductor_approximate(ior, k, cosine);
    out(Vec3<T>(R.parallel, R.perpendicular, R.unpolarised));
}
