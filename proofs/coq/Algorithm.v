(* ---------------------------------------------------------------------------------------------
   Algorithm 1 as a program.                                                 Section IV, Algorithm 1

   A program (Explorers.v) sees percepts only, and every step, every step back included, is a motion
   that it makes itself.  Turning on the spot is free and is folded into the next motion.

     knowledge            known_map   S;
                          unexplored  U, as a queue: the dart that came into S first stands first;
                          bearing0    how many darts clockwise of the dart faced at the start the
                                      marked one is;
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
     lighthouse           what the algorithm has to know of the markers:
                            set_out             from the first percept to line 1;
                            reads, foretells    a percept, and what S foretells of it, in a form
                                                in which they can be compared; degrees come first;
                            confirm k f c       what else has to be done at v0, where a test has
                                                matched up to its last dart f: matched or not?
     directional          the lighthouse of the paper: the bearing is seen, nothing else to do.
                          Another one: TwoVertices.v.
     walk_to w k c        follow w, then leave by k; c: the turn that is due.             lines 4-5
     check_path w P c o   execute w while the percepts are those of P.                   lines 10-13
     go_back done c       retrace: undo the motions done.                                 line 15
     test_all             test the hypotheses one by one until one is confirmed.          lines 7-17
     augment              lines 18-21.
     one_pass             lines 3-21.
     estimate k           line 22: the darts of S are numbered by vertex, then clockwise; the root
                          is the dart that the robot is at.
     explorer_by L pol    the explorer: a function of the percepts so far.
     algorithm1 pol       with a directional lighthouse.
     machine              the same, step by step, without remembering what it has sensed; this is
                          what runs outside Coq.  Refinement.v: they are equal.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps Routes.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

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

(* line 1: at v0 with n darts, of which the one in place b is marked; c: the turn that is due *)
Definition knowledge_at_v0 n b c :=
  Knowledge (initial_map n) [seq (0, i) | i <- iota 0 n] b (0, 0) c.

Record lighthouse (O : Type) (B : eqType) := Lighthouse {
  set_out : O -> program O knowledge;
  reads : O -> nat * B;
  foretells : percept -> nat * B;
  confirm : knowledge -> dart -> nat -> program O (bool * nat) }.

Definition first_knowledge (o : percept) := knowledge_at_v0 o.1 (odflt 0 o.2) 0.
Definition directional : lighthouse percept [eqType of option nat] :=
  {| set_out := fun o => Return (first_knowledge o);
     reads := id; foretells := id;
     confirm := fun _ _ c => Return (true, c) |}.

Section Program.
Variables (O : Type) (B : eqType) (L : lighthouse O B) (pol : policy).
Local Notation program := (program O).

(* ---- Walking and testing ---- *)
Fixpoint walk_to w k c : program O :=
  if w is j :: w' then Go (c + j) (fun _ => walk_to w' k 0) else Go (c + k) (fun o => Return o).

(* done: what has to be undone: motions, each with the degree where it was made *)
Fixpoint check_path w (expected : seq (nat * B)) (done : seq (nat * nat)) c (o : O) :
    program (bool * seq (nat * nat) * nat) :=
  if expected is o' :: expected' then
    if reads L o == o' then
      if w is k :: w' then
        Go (c + k) (fun o1 => check_path w' expected' ((k, (reads L o).1) :: done) 0 o1)
      else Return (true, done, c)
    else Return (false, done, c)
  else Return (false, done, c).

Fixpoint go_back (done : seq (nat * nat)) c : program nat :=
  if done is (k, n) :: done' then Go c (fun _ => go_back done' (opposite n k)) else Return c.

Definition next_edge k :=
  let e := choose_edge pol k in if e \in unexplored k then e else head (0, 0) (unexplored k).
Definition way_to k e := route_or_else (known_map k) (choose_transit pol k e) (at_dart k) e.1.
Definition way_home k h := route_or_else (known_map k) (choose_home pol k h) h 0.
Definition hypotheses k e o :=
  let H := [seq h <- unexplored k | (h != e) &&
    (foretells L (expected_percept (bearing0 k) (known_map k) h) == reads L o)] in
  let H' := order_hypotheses pol k e H in
  if perm_eq H' H then H' else H.

Fixpoint test_all k o (hs : seq dart) c : program (option (dart * dart) * nat) :=
  if hs is h :: hs' then
    let way := way_home k h in
    let expected := map (foretells L) (expected_percepts (bearing0 k) (known_map k) way.1 h) in
    bind (check_path way.1 expected [::] c o) (fun result =>
      match result with
      | (true, done, c') =>
          bind (confirm L k way.2 c') (fun confirmed =>
            if confirmed.1 then Return (Some (h, way.2), confirmed.2)
            else bind (go_back done confirmed.2) (test_all k o hs'))
      | (false, done, c') => bind (go_back done c') (test_all k o hs')
      end)
  else Return (None, c).

Definition augment k e (o : O) (found : option (dart * dart) * nat) :=
  match found with
  | (Some (h, f), c) =>
      Knowledge (add_loop (known_map k) e h)
        [seq x <- unexplored k | (x != e) && (x != h)] (bearing0 k) f c
  | (None, c) =>
      let n := (reads L o).1 in
      Knowledge (add_vertex (known_map k) e n)
        ([seq x <- unexplored k | x != e] ++
         [seq (size (degrees (known_map k)), i) | i <- iota 1 n.-1])
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

(* line 22 *)
Definition number_of S (e : dart) := index e (darts S).
Definition estimate k :=
  let S := known_map k in let h := at_dart k in
  NumberedMap [seq number_of S (turn S 1 e) | e <- darts S]
              [seq number_of S (odflt e (partner S e)) | e <- darts S]
              (number_of S (turn S (opposite (degree_in S h.1) (due_turn k)) h)).

(* ---- The explorer ---- *)

(* line 2: the next motion, or the end *)
Definition next (p : program knowledge) : numbered_map + (nat * (O -> program knowledge)) :=
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
Definition explorer_by : explorer O numbered_map := fun seen =>
  if seen is o :: seen' then act (foldl sense (set_out L o) seen') else Move 0.

Section Machine.
Variables (D : Type) (moves : nat -> D -> D) (senses : D -> O).
Fixpoint machine fuel p d : seq (nat * O) * option numbered_map * D :=
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

Definition algorithm1 := explorer_by directional.
