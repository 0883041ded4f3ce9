# Steps a scene with contacts by MuJoCo or by Drake; driven by `cargo lab contacts`.
#
# In, a line of JSON each:  {"setting", "step", "model": FILE, "gravity", "settle": null or gravity, "duration",
#                            "frames", "start", "velocity", "forces", "elastic": N/m, "collides", "links", "once"}
# Out, a line each:         {"seconds", "poses": [frame][link] of x y z qw qx qy qz, "energy": [frame] of kinetic, potential}
#                           or {"error"}; the first line is {"version"}.
#
# "start" has by body {"free": [x y z qw qx qy qz]}, by joint {"ball": [w x y z]} and {"dof": number}; "velocity" has by body
# [turning x y z, moving x y z] in the world. With "settle", what lies is left for half a second under that gravity first, and is
# then set to rest. Frames are taken in a run of their own, so that the time is that of the steps alone, the least of several.

import json
import sys
import time

SETTLING = 0.5


def least(run, once):
    """The least time of a run (s)."""
    best, spent, rounds = float("inf"), 0.0, 0
    while rounds < 1 or not once and (rounds < 1000 if spent < 0.08 else rounds < 3 and spent < 0.5):
        took = run()
        best, spent, rounds = min(best, took), spent + took, rounds + 1
    return best


def mujoco_engine():
    import mujoco
    import numpy as np

    def measure(ask):
        m = mujoco.MjModel.from_xml_path(ask["model"])
        d = mujoco.MjData(m)
        h = ask["step"]
        m.opt.timestep = h
        m.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
        if ask["setting"] == "hard":
            # What is harder than two steps is softened by MuJoCo itself.
            m.geom_solref[:] = [2 * h, 1]
            m.geom_solimp[:, :2] = 0.9999
        if ask["elastic"]:
            # Acceleration for a depth and none for a speed; of one contact the stiffness, over what it carries.
            m.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
            m.geom_solref[:] = [-ask["elastic"] / m.body_mass.sum(), 0]
            m.geom_solimp[:, :2] = 0.9999

        def begin():
            mujoco.mj_resetData(m, d)
            for body, pose in ask["start"]["free"].items():
                at = m.jnt_qposadr[m.body_jntadr[m.body(body).id]]
                d.qpos[at : at + 7] = pose
            for joint, turn in ask["start"]["ball"].items():
                at = m.jnt_qposadr[m.joint(joint).id]
                d.qpos[at : at + 4] = turn
            for joint, value in ask["start"]["dof"].items():
                d.qpos[m.jnt_qposadr[m.joint(joint).id]] = value
            for joint, force in ask["forces"].items():
                d.qfrc_applied[m.jnt_dofadr[m.joint(joint).id]] = force

        def moving():
            d.qvel[:] = 0
            mujoco.mj_kinematics(m, d)
            for body, v in ask["velocity"].items():
                at = m.jnt_dofadr[m.body_jntadr[m.body(body).id]]
                turn = d.xmat[m.body(body).id].reshape(3, 3)
                d.qvel[at : at + 3] = v[3:]
                d.qvel[at + 3 : at + 6] = turn.T @ np.array(v[:3])

        begin()
        if ask["settle"]:
            m.opt.gravity[:] = ask["settle"]
            mujoco.mj_step(m, d, nstep=round(SETTLING / h))
            m.opt.gravity[:] = ask["gravity"]
        start = d.qpos.copy()
        count = round(ask["duration"] / h)

        def again():
            mujoco.mj_resetData(m, d)
            d.qpos[:] = start
            for joint, force in ask["forces"].items():
                d.qfrc_applied[m.jnt_dofadr[m.joint(joint).id]] = force
            moving()

        def timed():
            again()
            begun = time.perf_counter()
            mujoco.mj_step(m, d, nstep=count)
            return time.perf_counter() - begun

        seconds = least(timed, ask["once"])
        again()
        links = [m.body(name).id for name in ask["links"]]
        poses, energy, done = [], [], 0
        for frame in range(ask["frames"] + 1):
            until = round(count * frame / ask["frames"])
            mujoco.mj_step(m, d, nstep=until - done) if until > done else None
            done = until
            # What a step leaves is of its beginning.
            mujoco.mj_kinematics(m, d)
            mujoco.mj_comPos(m, d)
            mujoco.mj_makeM(m, d)
            mujoco.mj_comVel(m, d)
            mujoco.mj_energyPos(m, d)
            mujoco.mj_energyVel(m, d)
            poses.append([[*d.xpos[i], *d.xquat[i]] for i in links])
            energy.append([d.energy[1], d.energy[0]])
        if d.warning[int(mujoco.mjtWarning.mjWARN_BADQACC)].number:
            return {"error": "unstable"}
        return {"seconds": seconds, "poses": poses, "energy": energy}

    return f"MuJoCo {mujoco.__version__}", measure


def drake_engine():
    import importlib.metadata
    import logging

    import numpy as np
    from pydrake.common.eigen_geometry import Quaternion
    from pydrake.geometry import CollisionFilterDeclaration, GeometrySet, SceneGraphConfig
    from pydrake.math import RigidTransform, RollPitchYaw
    from pydrake.multibody.math import SpatialVelocity
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlantConfig
    from pydrake.systems.analysis import Simulator
    from pydrake.systems.framework import DiagramBuilder

    # It tells of every attribute that it does not know.
    logging.getLogger("drake").setLevel(logging.ERROR)

    def placed(pose):
        return RigidTransform(Quaternion(np.array(pose[3:]) / np.linalg.norm(pose[3:])), pose[:3])

    def built(ask, gravity):
        builder = DiagramBuilder()
        scene = SceneGraphConfig()
        properties = scene.default_proximity_properties
        # Faces of boxes touch in patches; spheres as small as points have none.
        properties.compliance_type = "compliant" if ask["collides"] else "undefined"
        if ask["elastic"]:
            properties.point_stiffness = 2 * ask["elastic"]
            properties.hunt_crossley_dissipation = 0.0
            properties.relaxation_time = 0.0
        config = MultibodyPlantConfig(time_step=ask["step"], discrete_contact_approximation=ask["setting"])
        plant, graph = AddMultibodyPlant(config, scene, builder)
        models = Parser(plant).AddModels(ask["model"])
        plant.mutable_gravity_field().set_gravity_vector(np.array(gravity))
        if not ask["collides"]:
            # Its reader does not know which geometries of the model are for the ground alone.
            bodies = [plant.get_body(i) for i in plant.GetBodyIndices(models[0])]
            moved = GeometrySet()
            for body in bodies:
                for geometry in plant.GetCollisionGeometriesForBody(body):
                    moved.Add(geometry)
            graph.collision_filter_manager().Apply(CollisionFilterDeclaration().ExcludeWithin(moved))
        plant.Finalize()
        return plant, builder.Build()

    def measure(ask):
        def started(gravity, positions):
            plant, diagram = built(ask, gravity)
            context = diagram.CreateDefaultContext()
            own = plant.GetMyMutableContextFromRoot(context)
            for body, pose in ask["start"]["free"].items():
                plant.SetFreeBodyPose(own, plant.GetBodyByName(body), placed(pose))
            for joint, turn in ask["start"]["ball"].items():
                plant.GetJointByName(joint).set_angles(own, RollPitchYaw(Quaternion(np.array(turn))).vector())
            for joint, value in ask["start"]["dof"].items():
                q = plant.GetPositions(own)
                q[plant.GetJointByName(joint).position_start()] = value
                plant.SetPositions(own, q)
            if positions is not None:
                plant.SetPositions(own, positions)
            forces = np.zeros(plant.num_velocities())
            for joint, force in ask["forces"].items():
                forces[plant.GetJointByName(joint).velocity_start()] = force
            plant.get_applied_generalized_force_input_port().FixValue(own, forces)
            return plant, diagram, context, own

        positions = None
        if ask["settle"]:
            plant, diagram, context, own = started(ask["settle"], None)
            Simulator(diagram, context).AdvanceTo(SETTLING)
            positions = plant.GetPositions(own)
        plant, diagram, context, own = started(ask["gravity"], positions)
        for body, v in ask["velocity"].items():
            plant.SetFreeBodySpatialVelocity(own, plant.GetBodyByName(body), SpatialVelocity(w=v[:3], v=v[3:]))
        simulator = Simulator(diagram, context)
        start = plant.GetPositionsAndVelocities(own)

        def again():
            context.SetTime(0)
            plant.SetPositionsAndVelocities(own, start)
            simulator.Initialize()

        def timed():
            again()
            begun = time.perf_counter()
            simulator.AdvanceTo(ask["duration"])
            return time.perf_counter() - begun

        seconds = 0.0 if ask["once"] else least(timed, False)
        again()
        bodies = [plant.GetBodyByName(name) for name in ask["links"]]
        poses, energy = [], []
        for frame in range(ask["frames"] + 1):
            begun = time.perf_counter()
            simulator.AdvanceTo(ask["duration"] * frame / ask["frames"])
            # Where one run is enough it is this one, without what is read of it.
            seconds += time.perf_counter() - begun if ask["once"] else 0.0
            told = []
            for body in bodies:
                pose = plant.EvalBodyPoseInWorld(own, body)
                turn = pose.rotation().ToQuaternion()
                told.append([*pose.translation(), turn.w(), turn.x(), turn.y(), turn.z()])
            poses.append(told)
            energy.append([plant.EvalKineticEnergy(own), plant.EvalPotentialEnergy(own)])
        return {"seconds": seconds, "poses": poses, "energy": energy}

    return f"Drake {importlib.metadata.version('drake')}", measure


def main():
    version, measure = {"mujoco": mujoco_engine, "drake": drake_engine}[sys.argv[1]]()
    print(json.dumps({"version": version}), flush=True)
    for line in sys.stdin:
        try:
            answer = measure(json.loads(line))
        except Exception as error:  # Whatever it is, the next scene is measured.
            answer = {"error": " ".join(str(error).split())[:300]}
        print(json.dumps(answer), flush=True)


main()
