template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const T a = in.number();
    const T b = in.number();
    const T c = in.number();
    if (task == 1) {
        out(static_cast<T>(differential_solid_angle(a, b, c)));
    } else if (task == 2) {  // a sky that is brighter above and on one side
        out(static_cast<T>(irradiance(16, [&](double theta, double phi) {
            return a + b * std::cos(theta) + c * std::cos(phi) * std::sin(theta);
        })));
    } else if (task == 3) {
        const Vec2<T> e = irradiance_of_disk(a, b, c);
        out(e.x);
        out(e.y);
    }
}
