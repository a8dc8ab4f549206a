(* ---------------------------------------------------------------------------------------------
   The model: worlds, explorers, and when an explorer is right.  Definitions only; with Main.v this is
   what a referee has to read.                                                Sections II, IV, V, VI

   The world is an embedding of a finite connected graph: a combinatorial map.  It is given by its
   darts (a dart is one end of an edge) and two permutations of them:
     sigma d              the next dart clockwise round the same vertex;
     alpha d              the other end of the same edge: an involution without fixed points.
   Vertices are the cycles of sigma, edges those of alpha.  Loops and parallel edges are allowed,
   the surface may have any genus, nothing is said of the number of vertices or edges.

     combinatorial_map    such a pair of permutations on a finite type, connected.  A map G stands
                          for the type of its darts as well: d : G is a dart of G.
     adjacent x y         y is sigma x or alpha x; connected: any two darts are joined by such
                          steps.
     at_same_vertex x y   x and y are darts of one vertex.
     degree d             the number of darts at the vertex of d.
     vertices G, edges G  how many vertices and edges G has: the paper's n and m.
     motion k d           the robot has come in by d (or faces d, at the start); it leaves by the
                          k-th dart clockwise from d, and stands then in the dart at the other
                          end. One motion is one edge traversal; turning on the spot is free.
     walk w d             where the motions of the list w lead from d.
   A robot's state is a dart, not a vertex, because the door by which it came in is all that its
   next turn can refer to.

   A directional lighthouse:
     percept              what is sensed at a vertex: its degree and, where the directional
                          marker lies, its bearing: how many darts clockwise from the dart by
                          which the robot came in the pointed dart is.  No bearing: no marker
                          here.  This is the paper's signature: degree, presence and direction
                          of the marker.
     lighthouse_world     a map, the dart `start` that the robot faces at the start, and the
                          dart `pointed` to which the marker points; both are darts of one
                          vertex, the paper's v0.  Any map, any start dart, any bearing.
     percept_of d         what the robot senses when it has come in by d.
     percepts_along w d   what it senses on the way of the motions w from d, the first percept
                          (before any motion) included.
     first_bearing W      the bearing sensed at the start.

   An answer to SLAM is a map and the robot's place in it: a rooted map.
     rooted_map           sigma, alpha and a root on the members of a type that satisfy is_dart; a
                          type with a predicate, so that finite types, numbers and infinite types
                          all fit.
     wellformed M         sigma is injective, alpha an involution without fixed points, on the
                          darts.
     connected M          every dart is reached from the root by sigma and alpha.
     rooted_at M d        M seen from the dart d.
     isomorphic M N       the same rooted map: a bijection of the darts that commutes with sigma and
                          alpha and takes root to root.  This is the paper's extended isomorphism (a
                          graph isomorphism and one cyclic relabelling a vertex, the edge-index
                          condition), with the robot's place.
     motion_in, walk_in   motion and walk in a rooted map.
     rooted d             a combinatorial_map, seen from its dart d.
     numbered_map         a rooted map that can be written down: lists sigma_list, alpha_list and a
                          number root_number; dart i is the number i.
     denote M             the rooted map that M writes down;  valid M: it is one;
     seen_from M d        the same lists, another root.

     action, explorer     an explorer is any function from the percepts so far (the first one first)
                          to an action: a motion, or to stop with an answer of any type.  It never
                          holds a world, so whatever holds of all explorers holds of all algorithms.
     episode X M obs n    explorer X in the rooted map M, where obs d is sensed in dart d, for at
                          most n motions: the transcript (motion, percept), the answer, the robot's
                          true dart. No answer: the n motions were not enough.
     right                it stops, and its answer denotes a rooted map that is isomorphic to the
                          world seen from the robot's true dart: the same map, and the right place
                          in it.
     same_map M N         M is N seen from some dart: the same map, the place left open.
     finds_map            it stops, and its answer denotes the world's map; whether the place in it
                          is right is not asked.
     no_explorer_finds_both M N   no explorer finds the map of M and the map of N: whatever its answers
                          are, whatever they are taken to mean.

     simple_world W       no loop, and no two edges with the same ends.
     universe             what an explorer may rely on: nothing, or that the world is simple.
     finds_all_maps u     the explorer finds the map of every world of the universe u.

     paper_bound n m      (1) + (2) of Section VI, the upper limit of (2) read as m-n+1.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Maps ---- *)
Definition adjacent (D : finType) (sigma alpha : D -> D) : rel D :=
  fun x y => (y == sigma x) || (y == alpha x).

Record combinatorial_map := CombinatorialMap {
  darts_of :> finType;
  sigma : darts_of -> darts_of;
  alpha : darts_of -> darts_of;
  sigma_inj : injective sigma;
  alphaK : involutive alpha;
  alpha_neq : forall d, alpha d != d;
  connected_map : forall x y, connect (adjacent sigma alpha) x y }.

Arguments sigma {c} _.
Arguments alpha {c} _.
Arguments sigma_inj {c} [x1 x2] _.
Arguments alphaK {c} _.
Arguments alpha_neq {c} d.
Arguments connected_map {c} x y.

Section Maps.
Variable G : combinatorial_map.
Implicit Types (d x y : G) (w : seq nat) (k : nat).

Definition at_same_vertex x y := fconnect sigma x y.
Definition degree d := order sigma d.
Definition vertices := fcard (@sigma G) G.
Definition edges := fcard (@alpha G) G.

Definition motion k d := alpha (iter k sigma d).
Fixpoint walk w d := if w is k :: w' then walk w' (motion k d) else d.
End Maps.

Arguments motion {G} k d.
Arguments walk {G} w d.

(* ---- A directional lighthouse ---- *)
Definition percept := (nat * option nat)%type.

Record lighthouse_world := LighthouseWorld {
  map_of :> combinatorial_map;
  start : map_of;
  pointed : map_of;
  pointed_at_v0 : at_same_vertex start pointed }.

Arguments start {l}.
Arguments pointed {l}.

Section Percepts.
Variable W : lighthouse_world.
Implicit Types (d : W) (w : seq nat).

Definition bearing d :=
  if at_same_vertex d pointed then Some (findex sigma d pointed) else None.
Definition percept_of d : percept := (degree d, bearing d).
Fixpoint percepts_along w d : seq percept :=
  percept_of d :: (if w is k :: w' then percepts_along w' (motion k d) else [::]).
Definition first_bearing := findex sigma start (@pointed W).
End Percepts.

Arguments first_bearing W : clear implicits.

(* ---- Rooted maps ---- *)
Record rooted_map := RootedMap {
  carrier : Type;
  is_dart : pred carrier;
  sigma_of : carrier -> carrier;
  alpha_of : carrier -> carrier;
  root : carrier }.
Arguments is_dart : clear implicits.
Arguments sigma_of : clear implicits.
Arguments alpha_of : clear implicits.
Arguments root : clear implicits.

Record wellformed M : Prop := Wellformed {
  wellformed_root : is_dart M (root M);
  wellformed_sigma : forall x, is_dart M x -> is_dart M (sigma_of M x);
  wellformed_alpha : forall x, is_dart M x -> is_dart M (alpha_of M x);
  wellformed_inj : forall x y, is_dart M x -> is_dart M y -> sigma_of M x = sigma_of M y -> x = y;
  wellformed_alphaK : forall x, is_dart M x -> alpha_of M (alpha_of M x) = x;
  wellformed_alpha_neq : forall x, is_dart M x -> alpha_of M x <> x }.

Definition rooted_at (M : rooted_map) (d : carrier M) :=
  RootedMap (is_dart M) (sigma_of M) (alpha_of M) d.
Arguments rooted_at : clear implicits.

(* what holds of the root and is kept by sigma and alpha holds of every dart *)
Definition connected M :=
  forall A : carrier M -> Prop, A (root M) ->
  (forall x, is_dart M x -> A x -> A (sigma_of M x)) ->
  (forall x, is_dart M x -> A x -> A (alpha_of M x)) ->
  forall x, is_dart M x -> A x.

(* the same rooted map: a bijection f, with inverse g, that commutes with sigma and alpha *)
Definition isomorphic M N := exists (f : carrier M -> carrier N) (g : carrier N -> carrier M),
  [/\ forall x, is_dart M x ->
        [/\ is_dart N (f x), g (f x) = x,
            f (sigma_of M x) = sigma_of N (f x) & f (alpha_of M x) = alpha_of N (f x)],
      forall y, is_dart N y -> is_dart M (g y) /\ f (g y) = y
    & f (root M) = root N].

Definition motion_in (M : rooted_map) k (d : carrier M) := alpha_of M (iter k (sigma_of M) d).
Arguments motion_in : clear implicits.
Fixpoint walk_in (M : rooted_map) (w : seq nat) (d : carrier M) :=
  if w is k :: w' then walk_in w' (motion_in M k d) else d.
Arguments walk_in : clear implicits.

Definition rooted (G : combinatorial_map) (d : G) := @RootedMap G xpredT sigma alpha d.

(* ---- Numbered maps ---- *)
Record numbered_map := NumberedMap { sigma_list : seq nat; alpha_list : seq nat; root_number : nat }.
Definition denote M :=
  @RootedMap nat (fun x => x < size (sigma_list M))
    (nth 0 (sigma_list M)) (nth 0 (alpha_list M)) (root_number M).
Definition seen_from M d := NumberedMap (sigma_list M) (alpha_list M) d.
Definition valid M :=
  let n := size (sigma_list M) in
  let alpha := nth 0 (alpha_list M) in
  [&& size (alpha_list M) == n, root_number M < n, all (fun x => x < n) (sigma_list M),
      all (fun x => x < n) (alpha_list M), uniq (sigma_list M) &
      all (fun i => (alpha (alpha i) == i) && (alpha i != i)) (iota 0 n)].

(* ---- Explorers ---- *)
Inductive action E := Move (k : nat) | Stop (answer : E).
Arguments Move {E} k.
Arguments Stop {E} answer.
Definition explorer P E := seq P -> action E.

Section Episodes.
Variables (P E : Type) (meaning : E -> rooted_map) (X : explorer P E).
Variables (M : rooted_map) (obs : carrier M -> P).

(* seen: the percepts so far; d: the robot's true dart *)
Fixpoint explore fuel (seen : seq P) d : seq (nat * P) * option E * carrier M :=
  match X seen with
  | Stop answer => ([::], Some answer, d)
  | Move k =>
      if fuel is fuel'.+1 then
        let d' := motion_in M k d in
        let: (transcript, answer, z) := explore fuel' (rcons seen (obs d')) d' in
        ((k, obs d') :: transcript, answer, z)
      else ([::], None, d)
  end.
Definition episode fuel := explore fuel [:: obs (root M)] (root M).

Definition right := exists fuel transcript answer z,
  [/\ episode fuel = (transcript, Some answer, z), wellformed (meaning answer) &
      isomorphic (meaning answer) (rooted_at M z)].

Definition same_map (M N : rooted_map) := exists2 d, is_dart N d & isomorphic M (rooted_at N d).
Definition finds_map := exists fuel transcript answer z,
  [/\ episode fuel = (transcript, Some answer, z), wellformed (meaning answer) &
      same_map (meaning answer) M].
End Episodes.

Arguments explore {P E} X M obs fuel seen d.
Arguments episode {P E} X M obs fuel.
Arguments right {P E} meaning X M obs.
Arguments finds_map {P E} meaning X M obs.

Definition no_explorer_finds_both P M N (obsM : carrier M -> P) (obsN : carrier N -> P) :=
  forall E (meaning : E -> rooted_map) (X : explorer P E),
  ~ (finds_map meaning X M obsM /\ finds_map meaning X N obsN).

(* a loop too is excluded: there alpha d would be another such dart than d *)
Definition simple_world (G : combinatorial_map) := forall d e : G,
  at_same_vertex d e -> at_same_vertex (alpha d) (alpha e) -> d = e.

Inductive universe := AllWorlds | SimpleWorlds.
Definition in_universe u (W : lighthouse_world) := if u is SimpleWorlds then simple_world W else True.
Definition finds_all_maps u E (meaning : E -> rooted_map) (X : explorer percept E) :=
  forall W : lighthouse_world, in_universe u W ->
  finds_map meaning X (rooted (@start W)) (@percept_of W).

(* ---- Cost ---- *)
Definition sum_1 n m := \sum_(1 <= s < n) (s + 2 * (s - 1) * (2 * m - 2 * (s - 1))).
Definition sum_2 n m :=
  \sum_(1 <= i < (m - (n - 1)).+1) (n + 2 * (n - 1) * (2 * m - 2 * (n - 1) - 2 * (i - 1))).
Definition paper_bound n m := sum_1 n m + sum_2 n m.
