//! Three determinants of gait: pelvic tilt, flexion of the stance knee, compass gait (thesis, chapter 7).
