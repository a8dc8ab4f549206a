//! Algorithm 1 in Rust, without a crate.
//!
//!     rustc -O --crate-type cdylib -o algorithm1.so examples/rust/algorithm1.rs
//!     allworlds check --native ./algorithm1.so --edges 6
//!
//! The declarations of `allworlds.h` stand at the end.  Between two calls the robot is in one of
//! its phases, each with what it must know there.  A panic aborts, as nothing may unwind into C.

use std::collections::VecDeque;
use std::ffi::c_void;

/// A dart of S; `twin` is itself where nobody knows yet where it leads.
struct Dart {
    twin: usize,
    vertex: usize,
    expected: Percept,
}

/// The paper's S and U; the darts of a vertex are consecutive and clockwise.
#[derive(Default)]
struct PartialMap {
    darts: Vec<Dart>,
    first: Vec<usize>,
    open: Vec<usize>,
}

impl PartialMap {
    fn degree(&self, dart: usize) -> usize {
        self.darts[dart].expected.degree as usize
    }

    fn turned(&self, dart: usize, motion: i32) -> usize {
        let first = self.first[self.darts[dart].vertex];
        let place = (dart - first) as i32 + motion;
        first + place.rem_euclid(self.degree(dart) as i32) as usize
    }

    fn add_vertex(&mut self, seen: Percept) -> usize {
        let (first, vertex) = (self.darts.len(), self.first.len());
        for dart in first..first + seen.degree as usize {
            self.darts.push(Dart { twin: dart, vertex, expected: seen });
            self.open.push(dart);
        }
        self.first.push(first);
        first
    }

    fn explore(&mut self, dart: usize, partner: usize) {
        self.darts[dart].twin = partner;
        self.darts[partner].twin = dart;
        self.open.retain(|&other| other != dart && other != partner);
    }

    /// The length of a shortest walk from each vertex to the goal.
    fn lengths(&self, goal: usize) -> Vec<i32> {
        let mut length = vec![-1; self.first.len()];
        let mut queue = VecDeque::from([goal]);
        length[goal] = 0;
        while let Some(v) = queue.pop_front() {
            for dart in self.first[v]..self.first[v] + self.degree(self.first[v]) {
                let w = self.darts[self.darts[dart].twin].vertex;
                if length[w] < 0 {
                    length[w] = length[v] + 1;
                    queue.push_back(w);
                }
            }
        }
        length
    }

    /// The darts by which a shortest walk leaves its vertices, the last one first.
    fn path(&self, start: usize, goal: usize) -> Vec<usize> {
        let length = self.lengths(goal);
        let (mut v, mut taken) = (start, Vec::new());
        while v != goal {
            let mut dart = self.first[v];
            while length[self.darts[self.darts[dart].twin].vertex] != length[v] - 1 {
                dart += 1;
            }
            taken.push(dart);
            v = self.darts[self.darts[dart].twin].vertex;
        }
        taken.reverse();
        taken
    }
}

/// A hypothesis on trial: e', the way to v0 that is left, and the motions made so far.
struct Trial {
    partner: usize,
    way: Vec<usize>,
    motions: Vec<i32>,
}

enum Phase {
    Passing,
    Following { way: Vec<usize>, goal: usize },
    Crossing { goal: usize },
    Testing { pass: Pass, trial: Trial },
    Retracing { pass: Pass, motions: Vec<i32>, turn: i32 },
}

/// The dart that is explored, what was seen behind it, and the hypotheses that are left.
struct Pass {
    goal: usize,
    seen: Percept,
    hypotheses: Vec<usize>,
}

struct Robot {
    s: PartialMap,
    here: usize,
    turned: i32,
    phase: Phase,
    pick: Option<Pick>,
    context: *mut c_void,
}

impl Robot {
    fn choose(&self, of: i32, options: &[usize], cost: &[i32]) -> usize {
        match self.pick {
            Some(pick) => pick(self.context, of, options.len() as i32, cost.as_ptr()) as usize,
            None => 0,
        }
    }

    fn start(&mut self, first: Percept) -> Action {
        self.s = PartialMap::default();
        (self.here, self.turned) = (0, 0);
        self.s.add_vertex(first);
        if first.bearing >= 0 {
            for dart in 0..first.degree {
                self.s.darts[dart as usize].expected.bearing =
                    (first.bearing - dart).rem_euclid(first.degree);
            }
        }
        self.next_pass()
    }

    fn step(&mut self, seen: Percept) -> Action {
        match std::mem::replace(&mut self.phase, Phase::Passing) {
            Phase::Passing => self.next_pass(),
            Phase::Following { way, goal } => self.follow(way, goal),
            Phase::Crossing { goal } => {
                let matching = |&dart: &usize| {
                    dart != goal && self.s.darts[dart].expected == seen
                };
                let hypotheses = self.s.open.iter().copied().filter(matching).collect();
                self.turned = 0;
                self.next_hypothesis(Pass { goal, seen, hypotheses })
            }
            Phase::Testing { pass, trial } => {
                if self.s.darts[self.here].expected == seen {
                    self.test(pass, trial)
                } else {
                    self.retrace(pass, trial.motions, 0)
                }
            }
            Phase::Retracing { pass, motions, turn } => self.retrace(pass, motions, turn),
        }
    }

    /// Lines 2-4.
    fn next_pass(&mut self) -> Action {
        if self.s.open.is_empty() {
            return Action { kind: ANSWER, motion: 0 };
        }
        let from = self.s.darts[self.here].vertex;
        let length = self.s.lengths(from);
        let cost: Vec<i32> =
            self.s.open.iter().map(|&dart| length[self.s.darts[dart].vertex]).collect();
        let goal = self.s.open[self.choose(EDGE, &self.s.open, &cost)];
        let way = self.s.path(from, self.s.darts[goal].vertex);
        self.follow(way, goal)
    }

    /// Lines 4-5.
    fn follow(&mut self, mut way: Vec<usize>, goal: usize) -> Action {
        match way.pop() {
            Some(dart) => {
                self.phase = Phase::Following { way, goal };
                self.leave_by(dart)
            }
            None => {
                self.phase = Phase::Crossing { goal };
                self.leave_by(goal)
            }
        }
    }

    fn leave_by(&mut self, dart: usize) -> Action {
        let motion = dart as i32 - self.here as i32;
        self.here = self.s.darts[dart].twin;
        Action { kind: MOVE, motion }
    }

    /// Lines 7-9, and where no hypothesis is left 20-21.
    fn next_hypothesis(&mut self, mut pass: Pass) -> Action {
        if pass.hypotheses.is_empty() {
            let entry = self.s.add_vertex(pass.seen);
            self.s.explore(pass.goal, entry);
            self.here = self.s.turned(entry, self.turned);
            return Action { kind: CHECKPOINT, motion: 0 };
        }
        let length = self.s.lengths(0);
        let cost: Vec<i32> =
            pass.hypotheses.iter().map(|&dart| length[self.s.darts[dart].vertex]).collect();
        let partner = pass.hypotheses.remove(self.choose(HYPOTHESIS, &pass.hypotheses, &cost));
        self.here = partner;
        let way = self.s.path(self.s.darts[partner].vertex, 0);
        self.test(pass, Trial { partner, way, motions: Vec::new() })
    }

    /// Lines 10-13, and where the test has come to v0 18-19.
    fn test(&mut self, pass: Pass, mut trial: Trial) -> Action {
        match trial.way.pop() {
            Some(dart) => {
                trial.motions.push(dart as i32 - self.here as i32);
                let mut action = self.leave_by(dart);
                action.motion -= std::mem::take(&mut self.turned);
                self.phase = Phase::Testing { pass, trial };
                action
            }
            None => {
                self.s.explore(pass.goal, trial.partner);
                Action { kind: CHECKPOINT, motion: 0 }
            }
        }
    }

    /// Line 15.
    fn retrace(&mut self, pass: Pass, mut motions: Vec<i32>, turn: i32) -> Action {
        match motions.pop() {
            Some(motion) => {
                self.phase = Phase::Retracing { pass, motions, turn: -motion };
                Action { kind: MOVE, motion: turn }
            }
            None => {
                self.turned = -turn;
                self.next_hypothesis(pass)
            }
        }
    }

    fn answer(&self, capacity: i32, sigma: *mut i32, alpha: *mut i32, here: &mut i32) -> i32 {
        let darts = self.s.darts.len();
        if darts <= capacity as usize {
            for dart in 0..darts {
                // SAFETY: there is room for `capacity` integers in both.
                unsafe {
                    *sigma.add(dart) = self.s.turned(dart, 1) as i32;
                    *alpha.add(dart) = self.s.darts[dart].twin as i32;
                }
            }
            *here = self.here as i32;
        }
        darts as i32
    }
}

// ---- allworlds.h

#[repr(C)]
#[derive(Clone, Copy, PartialEq)]
pub struct Percept {
    degree: i32,
    marks: i32,
    bearing: i32,
}

#[repr(C)]
pub struct Action {
    kind: i32,
    motion: i32,
}

type Pick = extern "C" fn(*mut c_void, i32, i32, *const i32) -> i32;

const VERSION: i32 = 2;
const MOVE: i32 = 1;
const CHECKPOINT: i32 = 4;
const ANSWER: i32 = 5;
const EDGE: i32 = 0;
const HYPOTHESIS: i32 = 1;

#[no_mangle]
pub extern "C" fn allworlds_version() -> i32 {
    VERSION
}

#[no_mangle]
pub extern "C" fn allworlds_new() -> *mut c_void {
    let robot = Robot {
        s: PartialMap::default(),
        here: 0,
        turned: 0,
        phase: Phase::Passing,
        pick: None,
        context: std::ptr::null_mut(),
    };
    Box::into_raw(Box::new(robot)).cast()
}

/// # Safety
/// `state` is what `allworlds_new` has returned; so it is below.
#[no_mangle]
pub unsafe extern "C" fn allworlds_delete(state: *mut c_void) {
    drop(Box::from_raw(state.cast::<Robot>()));
}

#[no_mangle]
pub unsafe extern "C" fn allworlds_choose(
    state: *mut c_void,
    pick: Option<Pick>,
    context: *mut c_void,
) {
    let robot = &mut *state.cast::<Robot>();
    (robot.pick, robot.context) = (pick, context);
}

#[no_mangle]
pub unsafe extern "C" fn allworlds_start(
    state: *mut c_void,
    percept: *const Percept,
    _told: i32,
    action: *mut Action,
) {
    *action = (*state.cast::<Robot>()).start(*percept);
}

#[no_mangle]
pub unsafe extern "C" fn allworlds_step(
    state: *mut c_void,
    percept: *const Percept,
    action: *mut Action,
) {
    *action = (*state.cast::<Robot>()).step(*percept);
}

#[no_mangle]
pub unsafe extern "C" fn allworlds_answer(
    state: *mut c_void,
    capacity: i32,
    sigma: *mut i32,
    alpha: *mut i32,
    here: *mut i32,
) -> i32 {
    (*state.cast::<Robot>()).answer(capacity, sigma, alpha, &mut *here)
}
