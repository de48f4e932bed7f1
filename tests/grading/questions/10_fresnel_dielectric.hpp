template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const T n1 = in.number();
    const T n2 = in.number();
    const T cosine = in.number();
    if (task == 1) {
        out(refracted_cosine(n1, n2, cosine));
    } else if (task == 2) {
        const Reflectances<T> R = fresnel_dielectric(n1, n2, cosine);
        out(Vec3<T>(R.parallel, R.perpendicular, R.unpolarised));
    }
}
