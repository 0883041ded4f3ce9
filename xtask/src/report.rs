//! How many digits are right and how long they take: the numbers and pictures of docs/accuracy.md.

mod accuracy;
mod cases;
mod samples;

pub(crate) fn run() -> Result<(), String> {
    let mut r = samples::Random::new(1);
    for n in [100, 200, 400] {
        let t = std::time::Instant::now();
        let s = samples::chain(&mut r, n)?;
        println!("figure {n} {:.2?}", t.elapsed());
        let t = std::time::Instant::now();
        let _ = solaris_dynamics::Tree::<f64>::new(&s.figure, samples::GRAVITY);
        println!("tree {n} {:.2?}", t.elapsed());
        let t = std::time::Instant::now();
        let _ = accuracy::inverse::<f64>(&s, solaris_dynamics::Formulation::NewtonEuler);
        println!("ne {n} {:.2?}", t.elapsed());
        let t = std::time::Instant::now();
        let _ = accuracy::inverse::<solaris_dynamics::scalar::DoubleDouble>(&s, solaris_dynamics::Formulation::NewtonEuler);
        println!("ne dd {n} {:.2?}", t.elapsed());
        let t = std::time::Instant::now();
        let _ = accuracy::inverse::<f64>(&s, solaris_dynamics::Formulation::TreeWise);
        println!("lag {n} {:.2?}", t.elapsed());
        let t = std::time::Instant::now();
        let _ = accuracy::forward::<f64>(&s);
        println!("fd {n} {:.2?}", t.elapsed());
        let t = std::time::Instant::now();
        let _ = accuracy::forward::<solaris_dynamics::scalar::DoubleDouble>(&s);
        println!("fd dd {n} {:.2?}", t.elapsed());
    }

    for case in cases::ORDINARY.iter().chain(&cases::HARD).filter(|c| std::env::args().nth(2).is_none_or(|n| c.name == n)) {
        let start = std::time::Instant::now();
        let accuracy = accuracy::measure(case)?;
        println!("{} {:.2?} {:?}", case.name, start.elapsed(), accuracy.condition);
        for (i, x) in accuracy.inverse.iter().enumerate() {
            let o = case.inverse.map(|o| o.of(solaris_dynamics::Formulation::ALL[i]));
            println!("   {i} {x:?} {o:?}");
        }
        println!("   fd {:?} {:?}", accuracy.forward, case.forward.map(|o| o.articulated));
        println!("   mat {:?} {:?}", accuracy.matrix, case.forward.map(|o| o.matrix));
    }
    Ok(())
}
