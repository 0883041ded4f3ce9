//! Figures.

use crate::error::{Failure, Status, guard, text};
use crate::given::{free, give, handle, words};
use solaris::files::{self, Body};
use solaris::model::{self, Human, RootOrder};
use std::ffi::{CString, c_char};
use std::path::Path;
use std::ptr;

/// An articulated figure. It never changes, and may be used by many threads at once.
pub struct Figure {
    pub(crate) body: Body,
    name: CString,
    links: Vec<CString>,
    q: Vec<CString>,
    v: Vec<CString>,
}

impl Figure {
    pub(crate) fn new(body: Body) -> Self {
        let all = |names: &[String]| names.iter().map(|name| text(name)).collect();
        let figure = &body.figure;
        Self {
            name: text(figure.name()),
            links: figure.links().iter().map(|link| text(link.name())).collect(),
            q: all(figure.layout().q_names()),
            v: all(figure.layout().v_names()),
            body,
        }
    }
}

/// Makes a person of this height (m) and mass (kg), whose root turns by its heading first, as `solaris_walker_new` needs it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_human(height: f64, mass: f64, out: *mut *mut Figure) -> Status {
    guard(|| {
        let figure = Human::new(height, mass).root(RootOrder::Yzx).build().map_err(Failure::refused)?;
        unsafe { give("out", out, Figure::new(Body::own(figure))) }
    })
}

/// Reads a figure from a file: `.ron`, `.urdf`, `.sdf`, `.xml` of `MuJoCo`, `.osim` or `.bvh`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_read(path: *const c_char, out: *mut *mut Figure) -> Status {
    guard(|| {
        let path = unsafe { words("path", path) }?;
        let body = files::body(Path::new(path)).map_err(Failure::unreadable)?;
        unsafe { give("out", out, Figure::new(body)) }
    })
}

/// Reads a figure from its text (RON).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_from_text(source: *const c_char, out: *mut *mut Figure) -> Status {
    guard(|| {
        let figure = model::text::read(unsafe { words("source", source) }?).map_err(Failure::unreadable)?;
        unsafe { give("out", out, Figure::new(Body::own(figure))) }
    })
}

/// Frees a figure; what was made of it stays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_free(figure: *mut Figure) {
    unsafe { free(figure) }
}

/// Its name; `NULL` of `NULL`. It is valid as long as the figure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_name(figure: *const Figure) -> *const c_char {
    unsafe { figure.as_ref() }.map_or(ptr::null(), |figure| figure.name.as_ptr())
}

/// Total mass (kg); 0 of `NULL`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_mass(figure: *const Figure) -> f64 {
    unsafe { figure.as_ref() }.map_or(0.0, |figure| figure.body.figure.mass())
}

/// Length of a configuration `q`; 0 of `NULL`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_nq(figure: *const Figure) -> usize {
    unsafe { figure.as_ref() }.map_or(0, |figure| figure.q.len())
}

/// Number of degrees of freedom, the length of `v`, `a` and `tau`; 0 of `NULL`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_nv(figure: *const Figure) -> usize {
    unsafe { figure.as_ref() }.map_or(0, |figure| figure.v.len())
}

/// Number of links; 0 of `NULL`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_links(figure: *const Figure) -> usize {
    unsafe { figure.as_ref() }.map_or(0, |figure| figure.links.len())
}

/// Name of a link; `NULL` where there is none. It is valid as long as the figure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_link_name(figure: *const Figure, link: usize) -> *const c_char {
    unsafe { name(figure, link, |figure| &figure.links) }
}

/// Index of a link's parent; -1 of the root, and where there is no such link.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_link_parent(figure: *const Figure, link: usize) -> isize {
    let parent = unsafe { figure.as_ref() }
        .and_then(|figure| figure.body.figure.links().get(link))
        .and_then(model::Link::parent);
    parent.map_or(-1, usize::cast_signed)
}

/// Name of an entry of `q`; `NULL` where there is none. It is valid as long as the figure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_q_name(figure: *const Figure, index: usize) -> *const c_char {
    unsafe { name(figure, index, |figure| &figure.q) }
}

/// Name of a degree of freedom; `NULL` where there is none. It is valid as long as the figure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_v_name(figure: *const Figure, index: usize) -> *const c_char {
    unsafe { name(figure, index, |figure| &figure.v) }
}

/// Writes the configuration in which every joint is at zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_figure_neutral(figure: *const Figure, q: *mut f64, nq: usize) -> Status {
    guard(|| {
        let figure = &unsafe { handle("figure", figure) }?.body.figure;
        let q = unsafe { crate::given::numbers_mut("q", q, nq, figure.layout().nq(), &[]) }?;
        figure.neutral(q).map_err(Failure::argument)
    })
}

unsafe fn name(figure: *const Figure, index: usize, of: fn(&Figure) -> &Vec<CString>) -> *const c_char {
    let found = unsafe { figure.as_ref() }.and_then(|figure| of(figure).get(index));
    found.map_or(ptr::null(), |name| name.as_ptr())
}
