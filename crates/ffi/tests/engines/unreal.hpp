// Stands in for Unreal's headers: of its names those that the walker's actor of docs/engines.md calls, with their signatures.
#include "solaris.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#define TEXT(text) text
#define UTF8_TO_TCHAR(text) text
#define UE_LOG(category, verbosity, format, ...) std::fprintf(stderr, format "\n", __VA_ARGS__)

struct FMath {
    template <class T> static T Min(T a, T b) { return std::min(a, b); }
};
template <class T> struct TArray {
    std::vector<T> of;
    void SetNumZeroed(std::size_t count) { of.assign(count, T()); }
    T *GetData() { return of.data(); }
    int Num() const { return static_cast<int>(of.size()); }
    T &operator[](std::size_t i) { return of[i]; }
};
struct FVector {
    double X, Y, Z;
    FVector(double X, double Y, double Z) : X(X), Y(Y), Z(Z) {}
};
inline FVector operator*(double scale, const FVector &v) { return {scale * v.X, scale * v.Y, scale * v.Z}; }
struct FQuat {
    double X, Y, Z, W;
    FQuat(double X, double Y, double Z, double W) : X(X), Y(Y), Z(Z), W(W) {}
};
struct FTransform {
    FQuat Rotation;
    FVector Translation;
    FTransform(const FQuat &Rotation, const FVector &Translation) : Rotation(Rotation), Translation(Translation) {}
};
struct FName {
    std::string Name;
    FName(const char *Name) : Name(Name) {}
};
namespace EBoneSpaces {
enum Type { WorldSpace, ComponentSpace };
}
namespace EEndPlayReason {
enum Type { Destroyed };
}
struct UPoseableMeshComponent {
    std::vector<std::pair<std::string, FTransform>> Bones;
    void SetBoneTransformByName(FName Bone, const FTransform &Transform, EBoneSpaces::Type) {
        for (auto &known : Bones)
            if (known.first == Bone.Name) {
                known.second = Transform;
                return;
            }
        Bones.push_back({Bone.Name, Transform});
    }
};
struct AActor {
    virtual void BeginPlay() {}
    virtual void Tick(float) {}
    virtual void EndPlay(const EEndPlayReason::Type) {}
    virtual ~AActor() = default;
};

// What the class of the actor declares: the stick is pushed ahead, and a little to the right.
struct ASolarisWalker : AActor {
    using Super = AActor;
    SolarisFigure *Figure = nullptr;
    SolarisWalker *Walker = nullptr;
    SolarisDynamics *Dynamics = nullptr;
    TArray<double> Q, Poses;
    UPoseableMeshComponent Body, *Mesh = &Body;
    double Right = 0.1f, Forward = 0.9f;
    void BeginPlay() override;
    void Tick(float DeltaSeconds) override;
    void EndPlay(const EEndPlayReason::Type Reason) override;
};
