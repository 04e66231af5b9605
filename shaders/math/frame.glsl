// Orthonormal basis around a unit normal, branchless. [Duff 17]
struct ShadingFrame {
    vec3 t, b, n;
};

ShadingFrame makeFrame(vec3 n) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z), c = n.x * n.y * a;
    return ShadingFrame(vec3(1.0 + s * n.x * n.x * a, s * c, -s * n.x), vec3(c, s + n.y * n.y * a, -n.y), n);
}

vec3 toLocal(ShadingFrame f, vec3 v) { return vec3(dot(v, f.t), dot(v, f.b), dot(v, f.n)); }
vec3 toWorld(ShadingFrame f, vec3 v) { return v.x * f.t + v.y * f.b + v.z * f.n; }
