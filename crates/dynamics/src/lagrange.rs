//! Inverse dynamics as the thesis writes it: Lagrange's equations over products of 4×4 matrices, in Denavit-Hartenberg
//! frames.
//!
//! Every degree of freedom i moves a *rationalised link* with a frame of its own ([`DenavitHartenberg`](crate::denavit_hartenberg::DenavitHartenberg)). With `A_i`
//! the matrix from frame i to the frame before it, `J_i` the pseudo-inertia of what frame i carries and `g` the
//! acceleration of gravity,
//!
//! ```text
//! W_j = W_{j−1}·A_j                                                                            (4.5)
//! Ẇ_j = Ẇ_{j−1}·A_j + W_{j−1}·A'_j·q̇_j                                                         (4.7)
//! Ẅ_j = Ẅ_{j−1}·A_j + 2·Ẇ_{j−1}·A'_j·q̇_j + W_{j−1}·A''_j·q̇_j² + W_{j−1}·A'_j·q̈_j               (4.8)
//! ∂W_j/∂q_j = W_{j−1}·A'_j                                                                     (4.9)
//! c_i = m_i·r_i + A_{i+1}·c_{i+1}                                                             (4.10)
//! D_i = J_i·Ẅ_iᵀ + A_{i+1}·D_{i+1}                                                            (4.11)
//! F_i = tr(∂W_i/∂q_i·D_i) − gᵀ·∂W_i/∂q_i·c_i                                                  (4.12)
//! ```
//!
//! with W, Ẇ, Ẅ from the root outwards and c, D, F back. The numbers are those of Vasilonikolidakis (1991); `docs/sources.md`
//! has a table of the slips that are put right here.
//!
//! The thesis orders coordinates (1 x y z)ᵀ; here they are (x y z 1)ᵀ: its row and column 0 are row and column 3, and its
//! rows and columns 1, 2, 3 are 0, 1, 2. Traces and products are the same in either order.
//!
//! | formulation | walks | equation by equation |
//! |---|---|---|
//! | [`chain_wise`] | every chain from the root to an end-effector on its own, §4.6 | `chain_wise.rs` |
//! | [`tree_wise`] | every rationalised link once | `tree_wise.rs` |
//!
//! Beyond the source: several links on one frame (welds), external wrenches, armature, and ball and free joints, which stand
//! at zero in a frame that is placed anew in every state.

mod chain_wise;
mod constants;
mod equations;
mod products;
mod state;
mod tree_wise;

pub use chain_wise::chain_wise;
pub use constants::Lagrangian;
pub use products::{Full, Products, Short};
pub use state::LagrangianWorkspace;
pub use tree_wise::tree_wise;
