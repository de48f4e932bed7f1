template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Rgb<float> first = in.uniform();
    const Rgb<float> second = in.uniform();
    if (task == 1) {
        const Incidence<T> g = in.incidence();
        const auto n = in.uniform_number();
        out(EnginePhong{.Cd = first, .F0 = second, .n = n}(g));
    } else if (task == 2) {
        out(EnginePhong{.Cd = first, .F0 = second, .n = 1}.ambient_albedo());
    } else if (task == 3) {
        Lighting lights;
        lights.directional = {{glm::vec3(0, 0, 1), first}, {glm::vec3(1, 0, 0), second}};
        lights.point = {{glm::vec3(1, 2, 3), second}};
        const Lighting scaled = lights_without_pi(lights);
        out(scaled.directional.at(0).irradiance);
        out(scaled.directional.at(1).irradiance);
        out(scaled.point.at(0).intensity);
    }
}
