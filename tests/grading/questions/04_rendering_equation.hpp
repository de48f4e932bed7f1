template <Real T>
void answer(int task, In<T> in, Out<T> out) {
    const Rgb<float> first = in.uniform();
    if (task == 1) {  // two lamps over a floor, the viewer above
        Lighting lights;
        lights.directional.resize(2);
        for (DirectionalLight& lamp : lights.directional) {
            lamp.irradiance = in.uniform();
        }
        for (DirectionalLight& lamp : lights.directional) {
            lamp.direction = in.uniform();
        }
        const Lit<UnnormalisedLambert> lit{{first}, lights, glm::vec3(0, 0, 5)};
        using Varyings = typename Lit<UnnormalisedLambert>::template Varyings<T>;
        out(lit(Varyings{Vec3<T>(T(0.0F)), Vec3<T>(T(0.0F), T(0.0F), T(1.0F))}));
    } else if (task == 2) {  // a sky that is brighter above
        const glm::vec3 L = in.uniform();
        const auto sky = [&](const glm::vec3& at) { return first * (1.5F + at.y); };
        const DirectionalLight lamp = lamp_of(sky, L, static_cast<float>(in.number()));
        out(lamp.irradiance);
        out(lamp.direction);
    } else if (task == 3) {
        out(UnnormalisedLambert{.Cd = first}.ambient_albedo());
    }
}
