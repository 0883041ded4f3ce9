int main() {
    SolarisWalkerNode node;
    node._ready();
    for (int frame = 0; frame < 150; frame++) node._process(1.0 / 60.0);
    for (std::size_t i = 0; i < node.bone_names.size(); i++) {
        const Vector3 &p = node.bone_poses[i].origin;
        const Quaternion &q = node.bone_poses[i].basis.turn;
        std::printf("%s %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", node.bone_names[i].c_str(), p.x, p.y, p.z, q.x, q.y, q.z, q.w);
    }
}
