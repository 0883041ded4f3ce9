//! Splits of the ground's wrench between the feet that stand.

mod brace;
mod effort;
mod load;
mod pivot;
mod sharing;
mod transition;

use crate::ground::{BalanceFrame, GroundError, PlacedFeet, Stances};
use sharing::Sharing;
use solaris_model::Contact;

/// A rule that shares the ground's wrench between the feet that stand: an assumption, since the laws of motion give its
/// sum and nothing else. A foot that stands alone has all of it.
///
/// All of them know a *nominal centre of pressure* and a *share* of each foot that stands. The nominal centre goes from
/// the heel (the ball, where that lands lower) to where the foot presses when it first stands alone, and from where it last does to the tip (the heel, where that leaves
/// last), as `3x² − 2x³` of the time; half-way from the heel to the ball stands in for what a motion does not show. Where a foot that stands alone presses beside
/// its sole it goes on to do so for 0.15 s, ever less. The shares of two
/// feet are those with which their nominal centres make the whole centre of pressure, as near as may be: where that
/// lies between the feet says who bears how much, and it leads from 0 to 1 by itself. The shares of more than two, or
/// where nothing presses on the ground, rise and fall as `3x² − 2x³` of the time until the first of those that stand
/// when a foot comes has left, and since the last of those came that stay when it leaves, but not beyond the middle of
/// its stance, and are made to add up to 1.
#[doc(alias = "load sharing")]
#[doc(alias = "smooth transition assumption")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Split {
    /// The smooth transition assumption (Ren, Jones and Howard 2008, Journal of Biomechanics 41:2750), fitted to people
    /// who walk: of its own force when double support began, the trailing foot keeps
    ///
    /// ```text
    /// fore-aft: k₁ exp(−(2(t − T/3)/T)²) − 2 k₂ t/T      the rest: exp(−(2t/T)³)      k₁ = e^(4/9), k₂ = k₁ e^(−16/9)/2
    /// ```
    ///
    /// at the time `t` of a double support of length `T`. Its centre of pressure stays where it was on the ground, with
    /// the moment about the normal decaying like the rest; the leading foot has what is left of the whole wrench.
    /// Fore-aft is how the centre of mass travels over the ground in that time. It is for two feet, and for double
    /// support between two single ones; elsewhere the pivot split stands in for it.
    Transition,
    /// Forces that point at one pivot above the centre of mass, as people's do ([`crate::split_at_pivot`]), with these
    /// shares and nominal centres of pressure; the pivot is 1.43 times as high as the centre of mass.
    ///
    /// Two feet that stand, not in a double support of walking, push against each other besides, along the line between them: on the average so that
    /// the forces point at the hips, and from frame to frame by what the joints have it easiest with. With `e` along the line,
    ///
    /// ```text
    /// ±f e      f = 4 s_a s_b (fₑ + c)      c = Σ 4 s_a s_b (f_h − fₑ)/Σ 4 s_a s_b over that time
    /// f_h = s_b (L_a − F_a·e) − s_a (L_b − F_b·e)      L_i = Fₙᵢ (H_i − P_i)·e/((H_i − P_i)·n)
    /// ```
    ///
    /// where `fₑ` makes `Σ τ²` least over the joints of [`Split::Effort`], and `H_i` is where the leg hangs. No foot is made to lean by more than 0.3 of
    /// what it bears.
    #[default]
    Pivot,
    /// The least moments at the joints: in each frame, of all wrenches that add up to the whole, those for which
    ///
    /// ```text
    /// Σ_j (τ_j/(m g h))² + w Σᵢ (1/sᵢ − 1) [ |Fᵢ|²/(m g)² + |Mᵢ|²/(m g l)² ]
    /// ```
    ///
    /// is least, over all degrees of freedom but the root's and those of the toes (sliding ones with their force over
    /// `m g`). `h` is the height of the centre of mass, `Mᵢ` the moment about the foot's nominal centre of pressure,
    /// `l` half the length of the sole, `sᵢ` the share and `w` = 0.05: what costs much is to press on a foot that bears
    /// little. A foot with no share has no force. Nothing keeps a foot from pulling; it is reported where it does.
    Effort,
}

impl Split {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Transition, Self::Pivot, Self::Effort];

    /// What it is called.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Transition => "transition",
            Self::Pivot => "pivot",
            Self::Effort => "effort",
        }
    }

    /// The split of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|split| split.name() == name)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Split {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// What each foot got.
#[derive(Clone, Debug, PartialEq)]
pub struct Shared {
    /// By foot, one contact a frame; zero where the foot does not stand.
    pub contacts: Vec<Vec<Contact>>,
    /// Frames in which several feet stand, not in a double support between a single support of the one and one of the
    /// other: at the ends of a motion, in standing, with more than two feet. There the shares are a guess, and
    /// [`Split::Transition`] gives way to [`Split::Pivot`].
    pub irregular: usize,
}

/// Shares the whole wrench `total` ([`crate::ground::balance`]) between the feet that stand. The contacts of a frame in
/// which any foot stands add up to it, to rounding.
///
/// # Errors
///
/// Stances that are none, a total of other frames, more than two feet for [`Split::Transition`], and the first state that
/// the kernel refuses.
pub fn share(
    split: Split,
    feet: &PlacedFeet<'_>,
    stances: &Stances,
    total: &[BalanceFrame],
) -> Result<Shared, GroundError> {
    stances.check(feet.soles().len())?;
    let (found, rows) = (total.len(), feet.prepared().motion.len());
    if found != rows {
        return Err(GroundError::Length { what: "the whole wrench", found, expected: rows });
    }
    let sharing = Sharing::new(feet, stances, total);
    let frames = match split {
        Split::Transition => transition::share(&sharing)?,
        Split::Pivot => brace::share(&sharing)?,
        Split::Effort => effort::share(&sharing)?,
    };
    let track = |foot: usize| {
        let rows = frames.iter().enumerate();
        rows.map(|(row, parts)| sharing.contact(foot, row, &parts[foot])).collect()
    };
    let contacts = (0..feet.soles().len()).map(track).collect();
    Ok(Shared { contacts, irregular: sharing.irregular() })
}
