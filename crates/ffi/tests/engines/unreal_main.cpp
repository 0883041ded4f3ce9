int main() {
    ASolarisWalker actor;
    actor.BeginPlay();
    for (int frame = 0; frame < 150; frame++) actor.Tick(1.0f / 60.0f);
    for (const auto &bone : actor.Body.Bones) {
        const FVector &p = bone.second.Translation;
        const FQuat &q = bone.second.Rotation;
        std::printf("%s %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", bone.first.c_str(), p.X, p.Y, p.Z, q.X, q.Y, q.Z, q.W);
    }
    actor.EndPlay(EEndPlayReason::Destroyed);
}
