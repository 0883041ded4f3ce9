//! What leaving out saves.

fn main() {
    divan::main();
}
