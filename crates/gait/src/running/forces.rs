//! The whole force over a stride and the way of the centre of mass under it: both are linear in the laws' amplitudes.

use super::circulant::Circulant;
use super::laws::{Amplitudes, FORCE, ForceLaws, TWIST};
use super::prints::{Print, prints};
use super::style::RunStyle;
use crate::body::Body;
use crate::walking::G;
use nalgebra::{SMatrix, SVector, Vector3};

/// By how much amplitudes are expected to differ from their priors: of the fore-aft force (body weights), of the lateral one, of the
/// free moment (N m).
pub(super) const FORE_AFT_SPREAD: [f64; FORCE] = [0.05, 0.04, 0.04];
pub(super) const LATERAL_SPREAD: [f64; FORCE] = [0.03; FORCE];
pub(super) const TWIST_SPREAD: [f64; TWIST] = [6.0; TWIST];
/// What the lateral force's amplitudes are expected to be (body weights).
pub(super) const LATERAL: [f64; FORCE] = [0.06, 0.0, 0.0];
/// By how much the trunk's angles are expected to differ from what they are drawn to (rad).
pub(super) const TRUNK_SPREAD: f64 = 2.0 * std::f64::consts::PI / 180.0;
/// Moments of inertia of what turns with the trunk (kg m²; pitch, yaw, roll), and the mass and height of whom they belong to.
const INERTIA: [f64; 3] = [3.3, 0.65, 3.3];
const INERTIA_OF: (f64, f64) = (73.0, 1.75);

/// Moments of inertia of what turns with the trunk (kg m²): pitch, yaw, roll.
pub(super) fn trunk_inertia(body: &Body) -> Vector3<f64> {
    Vector3::from(INERTIA) * (body.mass / INERTIA_OF.0 * (body.height / INERTIA_OF.1).powi(2))
}

/// One harmonic of the horizontal force over the nodes (N), and the way that it moves the centre of mass (m).
struct Harmonic {
    force: Vec<f64>,
    way: Vec<f64>,
}

/// What the laws prescribe at the nodes of a stride, for amplitudes that are still open.
pub(super) struct Prescribed {
    pub(super) prints: Vec<[Print; 2]>,
    /// Vertical force (N).
    pub(super) vertical: Vec<f64>,
    /// Height of the centre of mass about its mean (m).
    pub(super) height: Vec<f64>,
    /// `Σ P F_y` of the feet, x and z (N m).
    pressed: Vec<[f64; 2]>,
    fore_aft: [Harmonic; FORCE],
    lateral: [Harmonic; FORCE],
    twist: [Vec<f64>; TWIST],
    prior: Amplitudes,
    integral: Circulant,
    double_integral: Circulant,
    /// Of the trunk: pitch, yaw, roll.
    pub(super) inertia: Vector3<f64>,
}

/// The force, the way of the centre of mass and the rate of the angular momentum about it, at every node.
pub(super) struct Carried {
    pub(super) amplitudes: Amplitudes,
    /// Of the centre of mass in the moving frame; its height is what was given.
    pub(super) com: Vec<Vector3<f64>>,
    /// Rate of the angular momentum about it (N m).
    pub(super) momentum_rate: Vec<Vector3<f64>>,
}

/// The body as the pass before left it.
pub(super) struct Before<'a> {
    /// Angular momentum about the centre of mass (N m s).
    pub(super) momentum: &'a [Vector3<f64>],
    /// Angles of the thorax about z, y, x, and what they are drawn to.
    pub(super) thorax: &'a [[f64; 3]],
    pub(super) drawn: &'a [[f64; 3]],
}

impl Prescribed {
    pub(super) fn new(body: &Body, style: &RunStyle, laws: &ForceLaws, nodes: usize) -> Self {
        let step = style.stride_time / nodes as f64;
        let weight = body.mass * G;
        let prints = prints(style, laws, body.leg.foot_length(), nodes);
        let second = Circulant::of_second(nodes, step);
        let of_both = |of: &dyn Fn(&Print) -> f64, right: f64| -> Vec<f64> {
            prints.iter().map(|[left, other]| of(left) + right * of(other)).collect()
        };
        let moved =
            |force: &[f64]| second.apply(&force.iter().map(|force| force / body.mass).collect::<Vec<f64>>());
        let harmonic = |of: &dyn Fn(&Print) -> f64, right: f64| {
            let force = of_both(&|print| weight * of(print), right);
            Harmonic { way: moved(&force), force }
        };
        let vertical = of_both(&|print| weight * print.laws.vertical, 1.0);
        let pressed = prints.iter().map(|feet| {
            [0, 2].map(|axis| {
                feet.iter().map(|print| print.pressure[axis] * weight * print.laws.vertical).sum()
            })
        });
        Self {
            height: moved(&vertical),
            pressed: pressed.collect(),
            fore_aft: std::array::from_fn(|k| harmonic(&|print| print.laws.fore_aft[k], 1.0)),
            lateral: std::array::from_fn(|k| harmonic(&|print| print.laws.lateral[k], -1.0)),
            twist: std::array::from_fn(|k| of_both(&|print| print.laws.twist[k], -1.0)),
            prior: Amplitudes { fore_aft: [style.braking, 0.0, 0.0], lateral: LATERAL, twist: [0.0; TWIST] },
            integral: Circulant::integral(nodes, step),
            double_integral: Circulant::double_integral(nodes, step),
            inertia: trunk_inertia(body),
            vertical,
            prints,
        }
    }

    /// The motion under forces whose amplitudes keep the trunk near to what it is drawn to; as expected, where no pass was before.
    /// `height` is that of the centre of mass.
    ///
    /// ```text
    /// ẍ = F_x/m   z̈ = F_z/m      the mean of z so that that of Ḣ_x is nothing
    /// Ḣ_x = (z − P_z) F_y − y F_z      Ḣ_z = (P_x − x) F_y + y F_x      Ḣ_y = [(P − c) × F]_y + T_y
    /// ```
    pub(super) fn carry(&self, height: &[f64], before: Option<&Before<'_>>) -> Carried {
        let nodes = height.len();
        let mut amplitudes = self.prior;
        if let Some(before) = before {
            // Moments about x of the centre of pressure, and of each harmonic with the way that it makes.
            let base: Vec<f64> = self.pressed.iter().map(|[_, z]| -z).collect();
            let moments = std::array::from_fn(|k| {
                let Harmonic { force, way } = &self.fore_aft[k];
                let moment = |i: usize| way[i] * self.vertical[i] - height[i] * force[i];
                self.without_mean(&(0..nodes).map(moment).collect::<Vec<f64>>())
            });
            let fore_aft = self.fit(
                before,
                0,
                &self.without_mean(&base),
                &moments,
                &self.prior.fore_aft,
                &FORE_AFT_SPREAD,
            );
            let base: Vec<f64> = self.pressed.iter().map(|[x, _]| *x).collect();
            let moments = std::array::from_fn(|k| {
                let Harmonic { force, way } = &self.lateral[k];
                (0..nodes).map(|i| height[i] * force[i] - way[i] * self.vertical[i]).collect()
            });
            let lateral = self.fit(before, 2, &base, &moments, &self.prior.lateral, &LATERAL_SPREAD);
            amplitudes = Amplitudes { fore_aft, lateral, ..amplitudes };
        }
        let sum = |harmonics: &[Harmonic; FORCE], amplitudes: &[f64; FORCE], of: fn(&Harmonic) -> &[f64]| {
            (0..nodes)
                .map(|i| harmonics.iter().zip(amplitudes).map(|(h, a)| a * of(h)[i]).sum())
                .collect::<Vec<f64>>()
        };
        let force_z = sum(&self.fore_aft, &amplitudes.fore_aft, |h| &h.force);
        let force_x = sum(&self.lateral, &amplitudes.lateral, |h| &h.force);
        let mut z = sum(&self.fore_aft, &amplitudes.fore_aft, |h| &h.way);
        let x = sum(&self.lateral, &amplitudes.lateral, |h| &h.way);
        let about_x =
            |z: &[f64], i: usize| z[i] * self.vertical[i] - self.pressed[i][1] - height[i] * force_z[i];
        let ahead = (0..nodes).map(|i| about_x(&z, i)).sum::<f64>() / self.vertical.iter().sum::<f64>();
        for z in &mut z {
            *z -= ahead;
        }
        let twisted: Vec<f64> = (0..nodes)
            .map(|i| {
                let standing = self.prints[i].iter().filter(|print| print.stands);
                standing
                    .map(|print| {
                        (print.pressure.z - z[i]) * force_x[i] - (print.pressure.x - x[i]) * force_z[i]
                    })
                    .sum()
            })
            .collect();
        if let Some(before) = before {
            amplitudes.twist = self.fit(before, 1, &twisted, &self.twist, &self.prior.twist, &TWIST_SPREAD);
        }
        let momentum_rate = (0..nodes).map(|i| {
            let free: f64 = self.twist.iter().zip(&amplitudes.twist).map(|(law, a)| a * law[i]).sum();
            let about_z = self.pressed[i][0] - x[i] * self.vertical[i] + height[i] * force_x[i];
            Vector3::new(about_x(&z, i), twisted[i] + free, about_z)
        });
        Carried {
            momentum_rate: momentum_rate.collect(),
            com: (0..nodes).map(|i| Vector3::new(x[i], height[i], z[i])).collect(),
            amplitudes,
        }
    }

    /// By how much the trunk turns from pass to pass: `∫(H_law − H)/I`, about z, y, x.
    pub(super) fn turn(&self, rate: &[Vector3<f64>], momentum: &[Vector3<f64>]) -> Vec<[f64; 3]> {
        let about = |axis: usize| {
            let law = self.integral.apply(&rate.iter().map(|rate| rate[axis]).collect::<Vec<f64>>());
            let missing: Vec<f64> = law.iter().zip(momentum).map(|(law, h)| law - h[axis]).collect();
            self.integral.apply(&missing)
        };
        let turns = [about(2), about(1), about(0)];
        let inertia = [2, 1, 0].map(|axis| self.inertia[axis]);
        (0..rate.len()).map(|i| [0, 1, 2].map(|k| turns[k][i] / inertia[k])).collect()
    }

    /// A moment less what the mean place of the centre of mass takes of it: the part of the vertical force that has its mean.
    fn without_mean(&self, moment: &[f64]) -> Vec<f64> {
        let part = moment.iter().sum::<f64>() / self.vertical.iter().sum::<f64>();
        moment.iter().zip(&self.vertical).map(|(moment, vertical)| moment - vertical * part).collect()
    }

    /// The amplitudes a of moments about one axis (x, y, z) that keep the trunk's angle θ near to what it is drawn to:
    ///
    /// ```text
    /// Σ_nodes [(θ + (∬(base + Σ aₖ momentₖ) − ∫H)/I − θ_law)/2°]²/n + Σ [(aₖ − priorₖ)/spreadₖ]²  least
    /// ```
    fn fit<const K: usize>(
        &self,
        before: &Before<'_>,
        axis: usize,
        base: &[f64],
        moments: &[Vec<f64>; K],
        prior: &[f64; K],
        spread: &[f64; K],
    ) -> [f64; K] {
        let nodes = base.len();
        let inertia = self.inertia[axis];
        let angle = 2 - axis;
        let column = |rows: &[[f64; 3]]| {
            let mean = rows.iter().map(|row| row[angle]).sum::<f64>() / nodes as f64;
            rows.iter().map(|row| row[angle] - mean).collect::<Vec<f64>>()
        };
        let (now, drawn) = (column(before.thorax), column(before.drawn));
        let base = self.double_integral.apply(base);
        let momentum = self.integral.apply(&before.momentum.iter().map(|h| h[axis]).collect::<Vec<f64>>());
        let turns: [Vec<f64>; K] = std::array::from_fn(|k| self.double_integral.apply(&moments[k]));
        let weight = 1.0 / (TRUNK_SPREAD * TRUNK_SPREAD * nodes as f64);
        let (mut matrix, mut right) = (SMatrix::<f64, K, K>::zeros(), SVector::<f64, K>::zeros());
        for i in 0..nodes {
            let row = SVector::<f64, K>::from_fn(|k, _| turns[k][i] / inertia);
            let missing = drawn[i] - now[i] - (base[i] - momentum[i]) / inertia;
            matrix += row * row.transpose() * weight;
            right += row * (missing * weight);
        }
        for k in 0..K {
            matrix[(k, k)] += spread[k].powi(-2);
            right[k] += prior[k] * spread[k].powi(-2);
        }
        matrix.cholesky().map_or(*prior, |factor| factor.solve(&right).into())
    }
}
