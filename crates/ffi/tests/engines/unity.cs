// Stands in for UnityEngine: of its names those that the walker's script of docs/engines.md calls; and a game of 150 frames.
namespace UnityEngine {
    public class MonoBehaviour { }
    public static class Input {
        public static float GetAxis(string axis) => axis == "Horizontal" ? 0.1f : 0.9f;
    }
    public static class Time {
        public static float deltaTime = 1f / 60f;
    }
    public static class Mathf {
        public static float Min(float a, float b) => a < b ? a : b;
    }
    public struct Vector3 {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    }
    public struct Quaternion {
        public float x, y, z, w;
        public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    }
    public class Transform {
        public Vector3 position; public Quaternion rotation;
        public void SetPositionAndRotation(Vector3 position, Quaternion rotation) { this.position = position; this.rotation = rotation; }
        public static implicit operator bool(Transform it) => it != null;
    }
    public static class Game {
        public static void Main() {
            var walker = new SolarisWalker();
            for (int i = 0; i < walker.bones.Length; i++) walker.bones[i] = new Transform();
            var own = System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic;
            System.Action<string> Call = name => typeof(SolarisWalker).GetMethod(name, own).Invoke(walker, null);
            Call("Start");
            for (int frame = 0; frame < 150; frame++) Call("Update");
            var plain = System.Globalization.CultureInfo.InvariantCulture;
            for (int i = 0; i < walker.bones.Length; i++) {
                var p = walker.bones[i].position; var q = walker.bones[i].rotation;
                System.Console.WriteLine(string.Format(plain, "{0} {1:G9} {2:G9} {3:G9} {4:G9} {5:G9} {6:G9} {7:G9}", i, p.x, p.y, p.z, q.x, q.y, q.z, q.w));
            }
            Call("OnDestroy");
        }
    }
}
