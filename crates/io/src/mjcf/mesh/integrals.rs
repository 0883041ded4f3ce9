//! Volume, centre and second moments of what triangles enclose.

use super::Triangle;
use super::hull::hull;
use solaris_model::{Matrix3, Placement, Rotation3, ShapeKind, UnitQuaternion, Vector3};

/// What of the triangles counts, in MuJoCo's words: `exact`, `legacy`, `shell`, `convex`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Counted {
    /// The solid inside of a closed surface.
    Signed,
    /// The pyramids from the middle to each triangle, whichever way it faces: of a solid that is not convex, more than all.
    Pyramids,
    /// The surface itself.
    Surface,
    /// The convex hull.
    Hull,
}

/// What triangles enclose, of density 1 (kg/m³, or kg/m² of a surface).
#[derive(Clone, Debug, PartialEq)]
pub(in crate::mjcf) struct Solid {
    /// Volume (m³), or area (m²) of a surface.
    pub(in crate::mjcf) volume: f64,
    /// Its centre (m).
    pub(in crate::mjcf) com: Vector3<f64>,
    /// Inertia about the centre over the mass (m²).
    pub(in crate::mjcf) gyration: Matrix3<f64>,
    /// The corners (m).
    corners: Vec<Vector3<f64>>,
}

impl Solid {
    /// Of triangles that turn to the left seen from outside.
    ///
    /// With the pyramid from a point `p` to a triangle `D E F` seen from it, and `C = 20` (a surface: its area and `C = 12`),
    ///
    /// ```text
    /// V = D·(E × F)/6      c = (D + E + F)/4      ∫xᵢxⱼ = V/C·Σ(2·DᵢDⱼ + … + DᵢEⱼ + DⱼEᵢ + …)
    /// ```
    ///
    /// # Source
    ///
    /// J. O'Rourke, Computational Geometry in C (second edition, 1998), §1.3.8; the choices of what counts are those of MuJoCo
    /// 4.0's documentation of `mesh/inertia`.
    pub(super) fn of(triangles: &[Triangle], counted: Counted) -> Result<Self, String> {
        if counted == Counted::Hull {
            let corners: Vec<Vector3<f64>> = triangles.iter().flatten().copied().collect();
            return Self::of(&hull(&corners)?, Counted::Signed);
        }
        let area = |[d, e, f]: &Triangle| (e - d).cross(&(f - d)).norm() / 2.0;
        let total: f64 = triangles.iter().map(area).sum();
        if !(total.is_finite() && total > 1e-14) {
            return Err(format!("its triangles have an area of {total} m² together"));
        }
        let weighted =
            triangles.iter().map(|triangle| triangle.iter().sum::<Vector3<f64>>() * (area(triangle) / 3.0));
        let middle = weighted.sum::<Vector3<f64>>() / total;
        let volume = |point: &Vector3<f64>, triangle: &Triangle| {
            let [d, e, f] = triangle.map(|corner| corner - point);
            match counted {
                Counted::Surface => area(triangle),
                Counted::Pyramids => (d.dot(&e.cross(&f)) / 6.0).abs(),
                _ => d.dot(&e.cross(&f)) / 6.0,
            }
        };
        let com = if counted == Counted::Surface {
            middle
        } else {
            let (mut whole, mut first) = (0.0, Vector3::zeros());
            for triangle in triangles {
                let part = volume(&middle, triangle);
                whole += part;
                first += (triangle.iter().sum::<Vector3<f64>>() - middle * 3.0) * (part / 4.0);
            }
            if !(whole.is_finite() && whole > 1e-14) {
                return Err(format!(
                    "it encloses {whole} m³: a flat mesh, or one whose triangles face inside"
                ));
            }
            middle + first / whole
        };
        let (mut whole, mut second) = (0.0, Matrix3::zeros());
        let parts = if counted == Counted::Surface { 12.0 } else { 20.0 };
        for triangle in triangles {
            let part = volume(&com, triangle);
            let corners = triangle.map(|corner| corner - com);
            // Σ 2·DᵢDⱼ + DᵢEⱼ + DⱼEᵢ … = ΣD·ΣDᵀ + Σ D·Dᵀ
            let sum: Vector3<f64> = corners.iter().sum();
            let squares =
                corners.iter().fold(sum * sum.transpose(), |all, corner| all + corner * corner.transpose());
            whole += part;
            second += squares * (part / parts);
        }
        let gyration = (Matrix3::identity() * second.trace() - second) / whole;
        Ok(Self { volume: whole, com, gyration, corners: triangles.iter().flatten().copied().collect() })
    }
}

impl Solid {
    /// The solid that MuJoCo fits to it, and where: as great as the box of the same inertia, or as that round the corners along
    /// the axes of inertia; its axis is that of the least moment.
    pub(in crate::mjcf) fn fitted(
        &self,
        kind: &str,
        box_of_corners: bool,
        scale: f64,
    ) -> (ShapeKind, Placement) {
        let eigen = self.gyration.symmetric_eigen();
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        let mut axes = Matrix3::from_columns(&order.map(|i| eigen.eigenvectors.column(i).into_owned()));
        if axes.determinant() < 0.0 {
            axes.column_mut(0).neg_mut();
        }
        let moments = Vector3::from(order.map(|i| eigen.eigenvalues[i]));
        let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
        let at = Placement::from_parts(self.com.into(), rotation);
        let (half, middle) = if box_of_corners {
            let along = self.corners.iter().map(|corner| axes.transpose() * (corner - self.com));
            let (low, high) = along.fold(
                (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)),
                |(low, high), corner| (low.inf(&corner), high.sup(&corner)),
            );
            ((high - low) / 2.0, (high + low) / 2.0)
        } else {
            // gyration² about x is (b² + c²)/3 of the half sizes
            (moments.map(|own| ((moments.sum() - 2.0 * own) * 1.5).max(0.0).sqrt()), Vector3::zeros())
        };
        let (a, b, c) = (half.x, half.y, half.z);
        let across = if box_of_corners { a.max(b) } else { f64::midpoint(a, b) };
        let kind = match kind {
            "sphere" if box_of_corners => ShapeKind::Sphere { radius: half.max() * scale },
            "sphere" => ShapeKind::Sphere { radius: half.mean() * scale },
            "capsule" => {
                let straight = if box_of_corners { c - across } else { (c - across / 2.0).max(0.0) };
                ShapeKind::Capsule { radius: across * scale, length: 2.0 * straight * scale }
            }
            "cylinder" => ShapeKind::Cylinder { radius: across * scale, length: 2.0 * c * scale },
            "ellipsoid" => ShapeKind::Ellipsoid { radii: half * scale },
            _ => ShapeKind::Box { size: half * (2.0 * scale) },
        };
        (kind, at * Placement::from_parts(middle.into(), UnitQuaternion::identity()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box of 2 × 4 × 6 m about (1, 2, 3), of twelve triangles.
    fn solid_box() -> Vec<Triangle> {
        let corner =
            |i: usize| Vector3::new((i & 1) as f64 * 2.0, (i >> 1 & 1) as f64 * 4.0, (i >> 2) as f64 * 6.0);
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let sides = faces.iter().map(|side| side.map(corner));
        sides.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
    }

    #[test]
    fn a_box_weighs_what_a_box_weighs() {
        for counted in [Counted::Signed, Counted::Pyramids] {
            let solid = Solid::of(&solid_box(), counted).expect("a solid");
            assert!((solid.volume - 48.0).abs() < 1e-12);
            assert!((solid.com - Vector3::new(1.0, 2.0, 3.0)).norm() < 1e-12);
            // (a² + b²)/12
            let expected = Vector3::new(52.0, 40.0, 20.0) / 12.0;
            assert!((solid.gyration - Matrix3::from_diagonal(&expected)).amax() < 1e-12);
        }
        let inside_out: Vec<Triangle> = solid_box().into_iter().map(|[a, b, c]| [a, c, b]).collect();
        assert!(Solid::of(&inside_out, Counted::Signed).is_err());
        assert!(Solid::of(&inside_out, Counted::Pyramids).is_ok());
    }

    #[test]
    fn a_shell_is_heavier_outside() {
        let shell = Solid::of(&solid_box(), Counted::Surface).expect("a shell");
        assert!((shell.volume - 88.0).abs() < 1e-12);
        let solid = Solid::of(&solid_box(), Counted::Signed).expect("a solid");
        assert!((0..3).all(|i| shell.gyration[(i, i)] > solid.gyration[(i, i)]));
    }

    #[test]
    fn what_encloses_nothing_is_refused() {
        let flat = [[Vector3::zeros(), Vector3::x(), Vector3::y()]];
        assert!(Solid::of(&flat, Counted::Signed).is_err());
        assert!(Solid::of(&flat, Counted::Surface).is_ok());
        assert!(Solid::of(&[], Counted::Surface).is_err());
    }
}
