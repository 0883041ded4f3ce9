//! The human figure: 21 segments, 66 degrees of freedom, any height and mass.

mod build;
mod child;
mod girth;
mod portion;
mod segments;

pub use portion::Portion;
pub(crate) use portion::portion;

use crate::fault::FigureError;
use crate::figure::Figure;
use segments::SEGMENTS;
use solaris_text::nearest;

/// Heights that a human figure may have (m).
const HEIGHT: (f64, f64) = (0.8, 2.3);
/// Body mass indices that a human figure may have (kg/m²).
const BODY_MASS_INDEX: (f64, f64) = (8.0, 80.0);
/// The most that a hand carries, over the person's mass.
const MOST_LOAD: f64 = 0.3;
/// By how much of its length one leg may be shorter than it would be.
const SHORTER: f64 = 0.1;
/// Factors that a single segment's length may be scaled by.
const SEGMENT_SCALE: (f64, f64) = (0.5, 2.0);

/// Why there is no such human.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HumanError {
    /// The height is out of range.
    #[error("height {height} m: a human figure is {} to {} m tall", HEIGHT.0, HEIGHT.1)]
    Height {
        /// What was asked (m).
        height: f64,
    },
    /// The mass is out of range for the height.
    #[error(
        "mass {mass} kg: at a height of {height} m a human figure has {} to {} kg \
         (body mass index {} to {} kg/m²)",
        (.lower * 100.0 - 1e-6).ceil() / 100.0, (.upper * 100.0 + 1e-6).floor() / 100.0, BODY_MASS_INDEX.0, BODY_MASS_INDEX.1
    )]
    Mass {
        /// What was asked (kg).
        mass: f64,
        /// At this height (m).
        height: f64,
        /// Least mass at this height (kg).
        lower: f64,
        /// Greatest mass at this height (kg).
        upper: f64,
    },
    /// No segment has this name.
    #[error("segment '{name}': there is none of that name{hint}; the segments are {known}")]
    Segment {
        /// What was asked.
        name: String,
        /// The nearest name, as a question.
        hint: String,
        /// All names.
        known: String,
    },
    /// The segment's length is out of range.
    #[error(
        "length of segment '{name}' {length} m: at a height of {height} m it can be {lower:.3} to {upper:.3} m"
    )]
    SegmentLength {
        /// The segment.
        name: String,
        /// What was asked (m).
        length: f64,
        /// At this height (m).
        height: f64,
        /// Least length (m).
        lower: f64,
        /// Greatest length (m).
        upper: f64,
    },
    /// Nothing is known of the proportions at this age.
    #[error("age {age}: proportions are known from {} years on, and from {} on they are an adult's", child::AGES.0, child::AGES.1)]
    Age {
        /// What was asked (years).
        age: f64,
    },
    /// A load is out of range, or in no hand.
    #[error(
        "load of {load} kg in the {hand} hand: a person of {mass} kg can carry 0 to {:.1} kg in a hand, left or right",
        MOST_LOAD * .mass
    )]
    Load {
        /// In which hand.
        hand: String,
        /// What was asked (kg).
        load: f64,
        /// Of the person (kg).
        mass: f64,
    },
    /// A cane is in no hand of a person's two.
    #[error("cane in the '{hand}' hand: a person holds one in the left or in the right one")]
    Cane {
        /// In which hand.
        hand: String,
    },
    /// A leg is shorter by too much, or none of a person's two.
    #[error(
        "{leg} leg shorter by {by} m: a leg of this person can be shorter by 0 to {most:.3} m, left or right"
    )]
    ShorterLeg {
        /// Which leg.
        leg: String,
        /// What was asked (m).
        by: f64,
        /// The most (m).
        most: f64,
    },
    /// No angle with limits has this name.
    #[error("limits of '{name}': a human has no angle of that name{hint}")]
    Limits {
        /// What was asked.
        name: String,
        /// The nearest name, as a question.
        hint: String,
    },
    /// The figure could not be built.
    #[error(transparent)]
    Figure(#[from] FigureError),
}

impl HumanError {
    /// Which number is out of its range, where one is: its name, itself and its least and greatest value, their unit. A load in a hand that there
    /// is not is out of none.
    ///
    /// ```
    /// let error = solaris_model::human(9.0, 70.0).unwrap_err();
    /// assert_eq!(error.range(), Some(("height", [9.0, 0.8, 2.3], "m")));
    /// let third = solaris_model::Human::new(1.65, 58.0).load("middle", 1.0).build().unwrap_err();
    /// assert_eq!(third.range(), None);
    /// ```
    pub fn range(&self) -> Option<(&'static str, [f64; 3], &'static str)> {
        let found = match *self {
            Self::Height { height } => Some(("height", [height, HEIGHT.0, HEIGHT.1], "m")),
            Self::Mass { mass, lower, upper, .. } => Some(("mass", [mass, lower, upper], "kg")),
            Self::SegmentLength { length, lower, upper, .. } => {
                Some(("segment length", [length, lower, upper], "m"))
            }
            Self::Age { age } => Some(("age", [age, child::AGES.0, f64::INFINITY], "years")),
            Self::Load { load, mass, .. } => Some(("load", [load, 0.0, MOST_LOAD * mass], "kg")),
            Self::ShorterLeg { by, most, .. } => Some(("shorter leg", [by, 0.0, most], "m")),
            _ => None,
        };
        found.filter(|(_, [value, lower, upper], _)| !(lower..=upper).contains(&value))
    }
}

/// A human of `height` (m) and `mass` (kg): 21 segments and 66 degrees of freedom.
///
/// The frame is x left, y up, z forward; in the zero posture the figure stands upright with arms and legs straight down,
/// the pelvis' origin at the world's origin. Every joint turns in the order Z-Y-X (side bend, twist, flexion); the root
/// first slides along x, y, z. [`Human::root`] lets the root turn by its heading first.
///
/// # Source
///
/// Segment masses, centres of mass and radii of gyration: P. de Leva, "Adjustments to Zatsiorsky-Seluyanov's segment
/// inertia parameters", Journal of Biomechanics 29 (1996) 1223–1230, the values for men (1.741 m, 73.0 kg), with the
/// upper trunk's mass shared with the clavicles and the foot's with the toes. Lengths scale with the height, masses with
/// the mass. Trunk, neck and head are stacked so that the vertex stands at the height: published lengths overlap there, and are
/// taken 0.87 times as long, with the published masses, radii of gyration in metres, and fractions of the length at which
/// the centres of mass lie. Shapes are as thick as each segment's mass and the density of its tissue (Dempster 1955) ask
/// for; head, hands and feet go with the height alone, as people's do. But for the stack, the thickness and the height of the
/// shoulders the numbers are those of the walk's reference figure (`fixtures/reference/smooth`): left and right are
/// mirror images and principal axes lie along the segments. The 66-dof model on which other engines were timed differs:
/// there the centres of mass of the trunk lie 1–2 mm off the midline, knee, ankle and toe joints 1–3 mm to the outside,
/// and the tensors are turned by up to a few degrees, to keep engines from taking short cuts.
///
/// # Errors
///
/// Heights outside 0.8–2.3 m and masses outside a body mass index of 8–80 kg/m² are refused with the range.
///
/// ```
/// let ann = solaris_model::human(1.65, 58.0)?;
/// assert_eq!((ann.links().len(), ann.layout().nv()), (21, 66));
/// assert!((ann.mass() - 58.0).abs() < 1e-12);
/// let knee = ann.anatomical_angle("left_knee.flexion").unwrap();
/// assert_eq!(ann.layout().v_names()[knee.dof], "left_knee.rx");
/// # Ok::<(), solaris_model::HumanError>(())
/// ```
pub fn human(height: f64, mass: f64) -> Result<Figure, HumanError> {
    Human::new(height, mass).build()
}

/// A human with an age, lengths of single segments, or limits of joints of their own.
///
/// ```
/// let long_thighs = solaris_model::Human::new(1.75, 73.0).segment_length("thigh", 0.46).build()?;
/// # Ok::<(), solaris_model::HumanError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Human {
    height: f64,
    mass: f64,
    age: Option<f64>,
    lengths: Vec<(String, f64)>,
    limits: Vec<(String, [f64; 2])>,
    loads: Vec<(String, f64)>,
    shorter: Vec<(String, f64)>,
    cane: Option<String>,
    joints: Joints,
    root: RootOrder,
}

/// In which order the root of a human turns, after it has slid along x, y, z.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[doc(alias = "Euler order")]
#[doc(alias = "gimbal lock")]
pub enum RootOrder {
    /// `R = Rz·Ry·Rx` as in every other joint, the thesis's order: singular where the body has turned by a quarter turn.
    #[default]
    Zyx,
    /// `R = Ry·Rz·Rx`, the heading first and outermost: the angle in the middle is the tilt to the side, so that an upright body
    /// turns as often as it likes. The heading goes on past a whole turn and is never wrapped.
    Yzx,
}

/// How the joints of a human move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Joints {
    /// Each by three angles.
    Angles,
    /// See [`Human::limp`].
    Limp,
}

impl Human {
    /// A human of `height` (m) and `mass` (kg).
    pub fn new(height: f64, mass: f64) -> Self {
        Self {
            height,
            mass,
            age: None,
            lengths: Vec::new(),
            limits: Vec::new(),
            loads: Vec::new(),
            shorter: Vec::new(),
            cane: None,
            joints: Joints::Angles,
            root: RootOrder::Zyx,
        }
    }

    /// Gives the human the proportions of a boy or girl of this age (years, 6 to 18): a longer and heavier head, shorter legs.
    /// From 18 on they are an adult's, to the bit. Without an age everybody is an adult in small.
    ///
    /// # Source
    ///
    /// Lengths: R. G. Snyder et al., *Anthropometry of infants, children and youths to age 18 for product safety design*,
    /// UM-HSRI-77-17 (1977): medians over single children of length to height, relative to those of 17 and older. Trunk and
    /// neck are what the height leaves. Masses: R. K. Jensen, *Journal of Biomechanics* 19 (1986) 359–368, at 12 years, and 22
    /// (1989) 529–536, at 6 and 18 years, relative to 18. Centres of mass and radii of gyration stay an adult's fractions of the lengths.
    ///
    /// ```
    /// let child = solaris_model::Human::new(1.15, 21.0).age(6.0).build()?;
    /// let head = |figure: &solaris_model::Figure| figure.link("head").unwrap().mass() / figure.mass();
    /// assert!(head(&child) > 2.0 * head(&solaris_model::human(1.15, 21.0)?));
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn age(mut self, years: f64) -> Self {
        self.age = Some(years);
        self
    }

    /// Gives an angle limits of its own (rad), by the name of its degree of freedom: `right_shoulder.rz`.
    ///
    /// ```
    /// let stiff = solaris_model::Human::new(1.75, 73.0).limits("left_elbow.rx", -1.0, 0.0).build()?;
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn limits(mut self, dof: impl Into<String>, lower: f64, upper: f64) -> Self {
        self.limits.push((dof.into(), [lower, upper]));
        self
    }

    /// Gives the human joints that no fall takes into gimbal lock, and the damping of tissue without muscles at work.
    ///
    /// - The root is a free joint and the shoulders are ball joints: whichever three angles one takes, a fall turns them into
    ///   lock, for they turn farther than a quarter turn each way. A ball joint has no limits, so what holds the upper arm is
    ///   the ground.
    /// - The elbows turn in the order X-Z-Y (flexion, carrying angle, pronation): the angle in the middle, which must not come
    ///   near ±90°, is the one that hardly turns. All others stay in the order Z-Y-X; their middle angle has a range of ±45° at
    ///   most.
    /// - Every joint has a damper, `d·v` on each of its degrees of freedom. At 1.741 m and 73 kg:
    ///
    /// | joint | `d` (N m s/rad) |
    /// |---|---|
    /// | lumbar, thorax | 2 |
    /// | hip | 1 |
    /// | neck, head, clavicle, shoulder, knee | 0.5 |
    /// | elbow, ankle | 0.2 |
    /// | wrist | 0.03 |
    /// | toes | 0.01 |
    ///
    /// The numbers are chosen, not measured: of the size that limbs have which swing out by themselves within a few swings. They
    /// go with `m·h^(3/2)`, so that bodies of like shape fall alike (Froude).
    ///
    /// There are 21 segments and 66 degrees of freedom as ever, 69 coordinates. The names of angles that are coordinates stay;
    /// those of root and shoulders are gone.
    ///
    /// ```
    /// let limp = solaris_model::Human::new(1.75, 73.0).limp().build()?;
    /// assert_eq!((limp.layout().nq(), limp.layout().nv()), (69, 66));
    /// assert!(limp.layout().v_names().contains(&"left_shoulder.wx".to_owned()));
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn limp(mut self) -> Self {
        self.joints = Joints::Limp;
        self
    }

    /// Lets the root turn in this order. Names and numbers of degrees of freedom stay, their order in `q` does not; a limp body's
    /// root is a free joint and has none.
    ///
    /// ```
    /// use solaris_model::{Human, RootOrder};
    ///
    /// let walker = Human::new(1.75, 73.0).root(RootOrder::Yzx).build()?;
    /// assert_eq!(walker.layout().v_names()[3..6], ["root.ry", "root.rz", "root.rx"]);
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn root(mut self, order: RootOrder) -> Self {
        self.root = order;
        self
    }

    /// Gives one segment a length of its own (m): `thigh` for both sides, `left_thigh` for one.
    pub fn segment_length(mut self, segment: impl Into<String>, length: f64) -> Self {
        self.lengths.push((segment.into(), length));
        self
    }

    /// Puts a load (kg) into the `left` or the `right` hand: a point mass in the fist, 90 mm below the wrist of a person of 1.741 m. The
    /// hand's mass, centre of mass and inertia are those of both; the person's own mass stays what it is.
    ///
    /// ```
    /// let porter = solaris_model::Human::new(1.75, 73.0).load("right", 5.0).build()?;
    /// assert!((porter.mass() - 78.0).abs() < 1e-12);
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn load(mut self, hand: impl Into<String>, load: f64) -> Self {
        self.loads.push((hand.into(), load));
        self
    }

    /// Gives the `left` or the `right` hand a cane: a link `cane` more, a rod that turns in the fist to the side and forward. It is fitted as canes
    /// are, so long that the elbow is bent by 30° as it stands beside somebody who stands straight, and weighs 0.4 kg a metre; the
    /// person's own mass stays what it is.
    ///
    /// ```
    /// let ann = solaris_model::Human::new(1.65, 58.0).cane("right").build()?;
    /// let cane = ann.link("cane").unwrap();
    /// assert!((0.75..0.85).contains(&-cane.tip().unwrap().y));
    /// assert_eq!((ann.links().len(), ann.layout().nv()), (22, 68));
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn cane(mut self, hand: impl Into<String>) -> Self {
        self.cane = Some(hand.into());
        self
    }

    /// Makes the `left` or the `right` leg shorter by so much (m): thigh and shank by the same part of their lengths. Masses stay what they are.
    ///
    /// ```
    /// let uneven = solaris_model::Human::new(1.75, 73.0).shorter_leg("left", 0.02).build()?;
    /// let below = |link: &str| -uneven.link(link).unwrap().joint().placement().translation.y;
    /// let leg = |side: &str| below(&format!("{side}_shank")) + below(&format!("{side}_foot"));
    /// assert!((leg("right") - leg("left") - 0.02).abs() < 1e-12);
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn shorter_leg(mut self, leg: impl Into<String>, by: f64) -> Self {
        self.shorter.push((leg.into(), by));
        self
    }

    /// The figure.
    ///
    /// # Errors
    ///
    /// [`HumanError`] names the value, and the range that it must lie in.
    pub fn build(&self) -> Result<Figure, HumanError> {
        let (height, mass) = (self.height, self.mass);
        if !(HEIGHT.0..=HEIGHT.1).contains(&height) {
            return Err(HumanError::Height { height });
        }
        let (lower, upper) = (BODY_MASS_INDEX.0 * height * height, BODY_MASS_INDEX.1 * height * height);
        // A mass that was computed from the index itself may miss it by rounding.
        if !(lower * (1.0 - 1e-9)..=upper * (1.0 + 1e-9)).contains(&mass) {
            return Err(HumanError::Mass { mass, height, lower, upper });
        }
        let child = match self.age {
            Some(age) if age.is_nan() || age < child::AGES.0 => return Err(HumanError::Age { age }),
            age => child::Proportions::at(age.unwrap_or(child::AGES.1)),
        };
        for (hand, load) in &self.loads {
            let in_all: f64 = self.loads.iter().filter(|(own, _)| own == hand).map(|(_, load)| load).sum();
            let is_hand = ["left", "right"].contains(&hand.as_str());
            if !is_hand || load.is_nan() || *load < 0.0 || !(0.0..=MOST_LOAD * mass).contains(&in_all) {
                return Err(HumanError::Load { hand: hand.clone(), load: in_all, mass });
            }
        }
        let cane = match self.cane.as_deref() {
            None => None,
            Some("left") => Some("left_"),
            Some("right") => Some("right_"),
            Some(hand) => return Err(HumanError::Cane { hand: hand.to_owned() }),
        };
        let mut factors: Vec<(String, f64)> = Vec::new();
        for (name, length) in &self.lengths {
            factors.push((name.clone(), self.factor(name, *length, &child)?));
        }
        for (leg, by) in &self.shorter {
            factors.extend(self.shortened(leg, *by, &factors, &child)?);
        }
        let figure = build::figure(&build::Body {
            height,
            mass,
            joints: self.joints,
            root: self.root,
            share: &|segment| child.mass(segment),
            factor: &|side, segment| {
                let own = factors.iter().rev().find(|(name, _)| name == side || name == segment);
                own.map_or_else(|| child.length(segment), |(_, factor)| *factor)
            },
            load: &|side| {
                let of = |(hand, _): &&(String, f64)| side.trim_end_matches('_') == hand;
                self.loads.iter().filter(of).map(|(_, load)| load).sum()
            },
            cane,
            limits: &|dof| self.limits.iter().rev().find(|(name, _)| name == dof).map(|(_, limits)| *limits),
        })?;
        match self.limits.iter().find(|(name, _)| !build::has_limits(&figure, name)) {
            Some((name, _)) => {
                let known = figure.layout().v_names().iter().filter(|name| build::has_limits(&figure, name));
                let hint = nearest(name, known.map(String::as_str));
                let hint = hint.map_or_else(String::new, |name| format!(" (did you mean '{name}'?)"));
                Err(HumanError::Limits { name: name.clone(), hint })
            }
            None => Ok(figure),
        }
    }

    /// The factors of thigh and shank of a leg that is shorter by `by` (m) than with `factors`.
    fn shortened(
        &self,
        leg: &str,
        by: f64,
        factors: &[(String, f64)],
        child: &child::Proportions,
    ) -> Result<[(String, f64); 2], HumanError> {
        let parts = ["thigh", "shank"].map(|segment| {
            let side = format!("{leg}_{segment}");
            let own = factors.iter().rev().find(|(name, _)| *name == side || name == segment);
            let factor = own.map_or_else(|| child.length(segment), |(_, factor)| *factor);
            (side, factor, build::below(segment) * build::scale(self.height))
        });
        let length: f64 = parts.iter().map(|(_, factor, below)| factor * below).sum();
        let most = SHORTER * length;
        if !["left", "right"].contains(&leg) || !(0.0..=most).contains(&by) {
            return Err(HumanError::ShorterLeg { leg: leg.to_owned(), by, most });
        }
        Ok(parts.map(|(side, factor, _)| (side, factor * (1.0 - by / length))))
    }

    fn factor(&self, name: &str, length: f64, child: &child::Proportions) -> Result<f64, HumanError> {
        let names = || SEGMENTS.iter().map(|segment| segment.name);
        let Some(segment) =
            SEGMENTS.iter().find(|s| s.name == name || (s.paired && is_side_of(name, s.name)))
        else {
            let hint =
                nearest(name, names()).map_or_else(String::new, |name| format!(" (did you mean '{name}'?)"));
            let known = names().collect::<Vec<_>>().join(", ");
            return Err(HumanError::Segment { name: name.to_owned(), hint, known });
        };
        let of_an_adult = segment.length * build::scale(self.height);
        let default = of_an_adult * child.length(segment.name);
        let (lower, upper) = (SEGMENT_SCALE.0 * default, SEGMENT_SCALE.1 * default);
        if !(lower..=upper).contains(&length) {
            let (name, height) = (name.to_owned(), self.height);
            return Err(HumanError::SegmentLength { name, length, height, lower, upper });
        }
        Ok(length / of_an_adult)
    }
}

/// Whether `sided` is `left_` or `right_` and then `name`.
fn is_side_of(sided: &str, name: &str) -> bool {
    ["left_", "right_"].iter().any(|side| sided.strip_prefix(side) == Some(name))
}
