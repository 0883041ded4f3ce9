//! Motion tables: one row a sample, one column a number.
//!
//! | columns | what | unit |
//! |---|---|---|
//! | `time` | time of the sample | s |
//! | `DOF.q` | position of each degree of freedom | m, rad |
//! | `DOF.v`, `DOF.a` | velocity, acceleration | m/s, rad/s, m/s², rad/s² |
//! | `DOF.tau` | generalized force, where it is known | N, N m |
//! | `LINK.fx fy fz` | contact force on the link, world axes | N |
//! | `LINK.mx my mz` | its moment about the world's origin, world axes | N m |
//! | `LINK.px py pz` | centre of pressure | m |
//!
//! A ball joint J has the columns `J.qx.q J.qy.q J.qz.q J.qw.q` (a unit quaternion) and `J.wx.v …`, `J.wx.a …`, `J.wx.tau
//! …` (along the link's own axes); a free joint has `J.px.q …`, `J.vx.v …`, `J.vx.a …`, `J.vx.tau …` before these.
//!
//! All `.q` stand first, then all `.v`, all `.a`, all `.tau`, then the contacts link by link; [`read`] takes them in any
//! order. Numbers have the fewest digits that read back to the same bits. A table keeps no events, no planted intervals
//! and nothing of [`solaris_model::MotionInfo`]: who reads it back has to know them.
//!
//! [`read_table`] takes any table of finite numbers below one line of headings: commas between fields, quotes where a
//! heading holds one, a byte order mark, line ends of Windows, blank lines, spaces around fields. Semicolons and tabs
//! between fields are refused, because a comma may then be a decimal point.

mod read;
mod rows;
mod table;
mod write;

pub use read::{frame_rate, read};
pub use rows::{Row, Rows, number_text, read_rows, write_row};
pub use table::{read_table, write_table};
pub use write::write;
