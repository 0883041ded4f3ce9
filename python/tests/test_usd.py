"""USD as Pixar's own library reads it: bones and skin are where the figure is."""

import numpy as np
import pytest

import solaris

pxr = pytest.importorskip("pxr", reason="usd-core is not installed")


def test_bones_and_skin_are_where_the_figure_is(tmp_path):
    from pxr import Usd, UsdGeom, UsdSkel

    walk = solaris.walk(height=1.65, mass=58.0, steps=3, rate=30)
    motion = walk.motion
    path = tmp_path / "walk.usda"
    motion.save(path)
    stage = Usd.Stage.Open(str(path))
    root = stage.GetDefaultPrim()
    assert UsdGeom.GetStageUpAxis(stage) == "Y" and stage.GetTimeCodesPerSecond() == 30
    assert stage.GetEndTimeCode() == len(motion) - 1

    cache = UsdSkel.Cache()
    skel_root = UsdSkel.Root(root)
    cache.Populate(skel_root, Usd.PrimDefaultPredicate)
    (binding,) = cache.ComputeSkelBindings(skel_root, Usd.PrimDefaultPredicate)
    query = cache.GetSkelQuery(binding.GetSkeleton())
    assert query.GetTopology().GetNumJoints() == len(walk.figure.links)
    (target,) = binding.GetSkinningTargets()
    mesh = UsdGeom.Mesh(target.GetPrim())
    dynamics = solaris.Dynamics(walk.figure)
    for sample in (0, 40, 77):
        joints = query.ComputeJointSkelTransforms(float(sample))
        places = np.array([joint.ExtractTranslation() for joint in joints])
        expected = dynamics.poses(motion.q[sample])[:, :3, 3]
        assert np.abs(places - expected).max() < 1e-6
        points = mesh.GetPointsAttr().Get()
        assert target.ComputeSkinnedPoints(query.ComputeSkinningTransforms(float(sample)), points, float(sample))
        points = np.array(points)
        # Its lowest points stand on the ground.
        assert abs(points[:, 1].min()) < 2e-3
        assert 1.55 < points[:, 1].max() < 1.70
