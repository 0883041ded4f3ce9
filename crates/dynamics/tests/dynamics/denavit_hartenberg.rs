//! Denavit-Hartenberg frames: the laws that they obey, the source's tables and matrices, the printed summary.

mod appendix_b;
mod appendix_c;
mod figures;
mod laws;
mod summary;
