//! Five determinants of gait: those three, pelvic rotation and the plantar flexion of the foot that leaves (thesis, chapter 8).
