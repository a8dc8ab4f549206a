(* ---------------------------------------------------------------------------------------------
   Algorithm 1 as a program.                                                 Section IV, Algorithm 1

   A program (Explorers.v) sees percepts only, and every step, every step back included, is a motion
   that it makes itself.  Turning on the spot is free and is folded into the next motion.

     knowledge            known_map   S;
                          unexplored  U, as a queue: the dart that came into S first stands first;
                          bearing0    the bearing sensed at the start;
                          at_dart     the robot's dart in S;
                          due_turn    the turn that it still has to make, to stand as if it had just
                                      come in by at_dart.
     policy               an oracle for everything that the paper leaves open; it sees all that is
                          known and answers
                            choose_edge         which dart leaves U                        line 3
                            choose_transit      the path to it                             line 4
                            order_hypotheses    the order of H                             line 8
                            choose_home         the path of a hypothesis to v0             line 9
                          Any functions make a policy.  A proposal that is not legal (a dart that is
                          not open; no path, or one as long as S has vertices; another set of
                          hypotheses) is replaced by the oldest dart, a breadth-first path, the order
                          of U.
     route S a v          a breadth-first path in S from dart a to vertex v, with the dart that it
                          arrives by.
     walk_to w k c        follow w, then leave by k; c: the turn that is due.             lines 4-5
     check_path w P c o   execute w while the percepts are those of P.                   lines 10-13
     go_back done c       retrace: undo the motions done.                                 line 15
     test_all             test the hypotheses one by one until one is confirmed.          lines 7-17
     augment              lines 18-21.
     one_pass             lines 3-21.
     estimate k           line 22: the darts of S are numbered by vertex, then clockwise; the root
                          is the dart that the robot is at.
     algorithm1 pol       the explorer: a function of the percepts so far.
     machine              the same, step by step, without remembering what it has sensed; this is
                          what runs outside Coq.  Refinement.v: they are equal.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps Percepts RootedMaps Explorers PartialMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Breadth-first paths in S ---- *)
Section Route.
Variable S : partial_map.

(* a vertex found, the path to it, the dart it arrives by *)
Definition branch := (nat * (seq nat * dart))%type.
Definition no_branch : branch := (0, ([::], (0, 0))).

Definition visit (w : seq nat) (c : dart) (T : seq branch) k :=
  if partner S (turn S k c) is Some g then
    if g.1 \in unzip1 T then T else rcons T (g.1, (rcons w k, g))
  else T.
(* the turns from c to the darts of its vertex, in the order of their places *)
Definition round (c : dart) :=
  [seq degree_in S c.1 - c.2 + i | i <- iota 0 (degree_in S c.1)].
Fixpoint grow fuel i (T : seq branch) :=
  if fuel is fuel'.+1 then
    if i < size T then
      let t := (nth no_branch T i).2 in
      grow fuel' i.+1 (foldl (visit t.1 t.2) T (round t.2))
    else T
  else T.
Definition tree (a : dart) := grow (size (degrees S)) 0 [:: (a.1, ([::], a))].
Definition route a v := let T := tree a in (nth no_branch T (index v (unzip1 T))).2.

(* the path w, if it is one *)
Definition route_or_else w a v :=
  if follow S w a is Some f then
    if (f.1 == v) && (size w < size (degrees S)) then (w, f) else route a v
  else route a v.
End Route.

(* ---- What the robot knows, and what it may choose ---- *)
Record knowledge := Knowledge {
  known_map : partial_map;
  unexplored : seq dart;
  bearing0 : nat;
  at_dart : dart;
  due_turn : nat }.

Record policy := Policy {
  choose_edge : knowledge -> dart;
  choose_transit : knowledge -> dart -> seq nat;
  order_hypotheses : knowledge -> dart -> seq dart -> seq dart;
  choose_home : knowledge -> dart -> seq nat }.

(* ---- Walking and testing ---- *)
Local Notation program := (program percept).

Fixpoint walk_to w k c : program percept :=
  if w is j :: w' then Go (c + j) (fun _ => walk_to w' k 0) else Go (c + k) (fun o => Return o).

(* done: what has to be undone: motions, each with the degree where it was made *)
Fixpoint check_path w (expected : seq percept) (done : seq (nat * nat)) c (o : percept) :
    program (bool * seq (nat * nat) * nat) :=
  if expected is o' :: expected' then
    if o == o' then
      if w is k :: w' then
        Go (c + k) (fun o1 => check_path w' expected' ((k, o.1) :: done) 0 o1)
      else Return (true, done, c)
    else Return (false, done, c)
  else Return (false, done, c).

Fixpoint go_back (done : seq (nat * nat)) c : program nat :=
  if done is (k, n) :: done' then Go c (fun _ => go_back done' (opposite n k)) else Return c.

Section Program.
Variable pol : policy.

Definition next_edge k :=
  let e := choose_edge pol k in if e \in unexplored k then e else head (0, 0) (unexplored k).
Definition way_to k e := route_or_else (known_map k) (choose_transit pol k e) (at_dart k) e.1.
Definition way_home k h := route_or_else (known_map k) (choose_home pol k h) h 0.
Definition hypotheses k e o :=
  let H := [seq h <- unexplored k | (h != e) && (expected_percept (bearing0 k) (known_map k) h == o)] in
  let H' := order_hypotheses pol k e H in
  if perm_eq H' H then H' else H.

Fixpoint test_all k o (hs : seq dart) c : program (option (dart * dart) * nat) :=
  if hs is h :: hs' then
    let way := way_home k h in
    let expected := expected_percepts (bearing0 k) (known_map k) way.1 h in
    bind (check_path way.1 expected [::] c o) (fun result =>
      match result with
      | (true, _, c') => Return (Some (h, way.2), c')
      | (false, done, c') => bind (go_back done c') (test_all k o hs')
      end)
  else Return (None, c).

Definition augment k e (o : percept) (found : option (dart * dart) * nat) :=
  match found with
  | (Some (h, f), c) =>
      Knowledge (add_loop (known_map k) e h)
        [seq x <- unexplored k | (x != e) && (x != h)] (bearing0 k) f c
  | (None, c) =>
      Knowledge (add_vertex (known_map k) e o.1)
        ([seq x <- unexplored k | x != e] ++
         [seq (size (degrees (known_map k)), i) | i <- iota 1 o.1.-1])
        (bearing0 k) (new_dart (known_map k)) c
  end.

Definition one_pass k : program knowledge :=
  let S := known_map k in
  let e := next_edge k in
  let way := way_to k e in
  let facing_e := degree_in S way.2.1 - way.2.2 + e.2 in
  bind (walk_to way.1 facing_e (due_turn k)) (fun o =>
  bind (test_all k o (hypotheses k e o) 0) (fun found =>
  Return (augment k e o found))).

(* line 1 *)
Definition first_knowledge (o : percept) :=
  Knowledge (initial_map o.1) [seq (0, i) | i <- iota 0 o.1] (odflt 0 o.2) (0, 0) 0.

(* line 22 *)
Definition number_of S (e : dart) := index e (darts S).
Definition estimate k :=
  let S := known_map k in let h := at_dart k in
  NumberedMap [seq number_of S (turn S 1 e) | e <- darts S]
              [seq number_of S (odflt e (partner S e)) | e <- darts S]
              (number_of S (turn S (opposite (degree_in S h.1) (due_turn k)) h)).

(* ---- The explorer ---- *)

(* line 2: the next motion, or the end *)
Definition next (p : program knowledge) : numbered_map + (nat * (percept -> program knowledge)) :=
  match p with
  | Go k f => inr (k, f)
  | Return s =>
      if unexplored s is _ :: _ then
        match one_pass s with Go k f => inr (k, f) | Return s' => inl (estimate s') end
      else inl (estimate s)
  end.

Definition sense (p : program knowledge) o := match next p with inl _ => p | inr (_, f) => f o end.
Definition act (p : program knowledge) : action numbered_map :=
  match next p with inl answer => Stop answer | inr (k, _) => Move k end.
Definition algorithm1 : explorer percept numbered_map := fun seen =>
  if seen is o :: seen' then act (foldl sense (Return (first_knowledge o)) seen') else Move 0.

Section Machine.
Variables (D : Type) (moves : nat -> D -> D) (senses : D -> percept).
Fixpoint machine fuel p d : seq (nat * percept) * option numbered_map * D :=
  match next p with
  | inl answer => ([::], Some answer, d)
  | inr (k, f) =>
      if fuel is fuel'.+1 then
        let d' := moves k d in
        let: (transcript, answer, z) := machine fuel' (f (senses d')) d' in
        ((k, senses d') :: transcript, answer, z)
      else ([::], None, d)
  end.
End Machine.
End Program.
