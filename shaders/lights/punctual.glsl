// Point, spot and directional lights. [KHR_lights_punctual]

// Radiant intensity over squared distance: what arrives at distance d along `toLight`. Candela over m^2.
vec3 punctualIrradiance(LightRecord light, vec3 toLight, float d2) {
    float window = 1.0, range = light.c.z;
    if (range > 0.0) {
        float q = d2 / (range * range);
        window = clamp(1.0 - q * q, 0.0, 1.0);
    }
    if (light.kind == kLightSpot) {
        float angle = clamp(-dot(light.b, toLight) * light.c.x + light.c.y, 0.0, 1.0);
        window *= angle * angle;
    }
    return light.color * (window / d2);
}
