// Stands in for godot-cpp: of its names those that the walker's node of docs/engines.md calls, with its signatures.
#include "solaris.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#define GDCLASS(type, base)
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define ERR_PRINT(text) std::fprintf(stderr, "%s\n", text)

// Single precision, as Godot is built unless asked otherwise.
struct Vector2 {
    float x, y;
};
struct Vector3 {
    float x, y, z;
    Vector3(float x, float y, float z) : x(x), y(y), z(z) {}
};
struct Quaternion {
    float x, y, z, w;
    Quaternion(float x, float y, float z, float w) : x(x), y(y), z(z), w(w) {}
};
struct Basis {
    Quaternion turn;
    Basis(const Quaternion &turn) : turn(turn) {}
};
struct Transform3D {
    Basis basis;
    Vector3 origin;
    Transform3D(const Basis &basis, const Vector3 &origin) : basis(basis), origin(origin) {}
};
struct String {
    std::string text;
    String(const char *text) : text(text) {}
};
using StringName = String;

// Somebody who pushes the stick ahead, and a little to the right.
struct Input {
    static Input *get_singleton() {
        static Input input;
        return &input;
    }
    Vector2 get_vector(const StringName &, const StringName &, const StringName &, const StringName &) const {
        return {0.1f, 0.9f};
    }
};

struct Node {
    virtual void _ready() {}
    virtual void _process(double) {}
    virtual ~Node() = default;
};

// A skeleton that has every bone but those of the toes.
struct Skeleton3D : Node {
    std::vector<std::string> bone_names;
    std::vector<Transform3D> bone_poses;
    int find_bone(const String &name) {
        if (name.text.find("toes") != std::string::npos) return -1;
        bone_names.push_back(name.text);
        bone_poses.push_back(Transform3D(Basis(Quaternion(0, 0, 0, 1)), Vector3(0, 0, 0)));
        return static_cast<int>(bone_names.size()) - 1;
    }
    void set_bone_global_pose(int bone, const Transform3D &pose) { bone_poses.at(static_cast<std::size_t>(bone)) = pose; }
};
