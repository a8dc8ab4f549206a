(* ---------------------------------------------------------------------------------------------
   Sensors: what a marker has to tell.  Which sensors that look at v0 alone suffice: definitions, and
   that those with primitive words do.

   A marked world is a map with one distinguished dart, the door, at v0; with a start, any dart of v0, it is
   a lighthouse_world: its `pointed` is the door.
     sensor A             gives each dart x of each map G with door r a letter of type A: lambda G r x.
     invariant            an isomorphism (renaming, SameWorld.v) changes no letter.
     percept_by lambda x  what a robot senses that has come by x: the degree, and the letter.
     indistinguishable lambda W W'   a bisimulation relates the starts: a relation between the darts under
                          which degrees and letters agree, and which is kept by sigma and alpha.
     sufficient lambda    any two indistinguishable worlds are isomorphic with their starts.
     rigid lambda W       no two darts of W look alike (indistinct, Ambiguity.v).
     coarser lambda mu    where mu and the degree agree, so does lambda: lambda is a function of the two.
     strictly_coarser     and mu is no function of lambda and the degree.
     minimal lambda       it suffices, and nothing strictly coarser does.
   A sensor at v0 shows 0 (blank) elsewhere, and at v0, of degree d, the letter w d b, b being the bearing:
   the number of darts clockwise from the dart come by to the door.
     at_v0 w              this sensor.
     word w d             its cyclic word for degree d, w d 0 ... w d (d-1).
     adequate u           the word u is primitive (Words.v) and not blank.
     position_word, directional_word, door_word   position: 1 ... 1; directional: 1 2 ... d; the door:
                          1 0 ... 0, one bit.
     half_word, distance_word, remainder_word q   in which half the door is; how far it is, the side not
                          told; the bearing modulo q.

     sufficient_finer     what is finer than a sensor that suffices suffices.
     at_v0_invariant      a sensor at v0 is a sensor.
     rigid_isomorphic     two indistinguishable worlds that are rigid are isomorphic with their starts.
     adequate_suffices    two indistinguishable worlds are isomorphic with their starts, and the door is
                          kept, if the word for the degree of v0 is adequate.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Indistinguishable PositionTwins Ambiguity.
From Allworlds Require Import SameWorld Words.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Sensors ---- *)
Definition sensor (A : Type) := forall G : combinatorial_map, G -> G -> A.

Definition invariant A (lambda : sensor A) := forall (G H : combinatorial_map) (f : G -> H), renaming f ->
  forall r x, lambda H (f r) (f x) = lambda G r x.

Definition percept_by A (lambda : sensor A) (W : lighthouse_world) (x : W) := (degree x, lambda W pointed x).

Definition indistinguishable A (lambda : sensor A) (W W' : lighthouse_world) :=
  exists R : W -> W' -> Prop,
  [/\ forall x y, R x y -> percept_by lambda x = percept_by lambda y,
      forall x y, R x y -> R (sigma x) (sigma y),
      forall x y, R x y -> R (alpha x) (alpha y) & R start start].

Definition sufficient A (lambda : sensor A) := forall W W' : lighthouse_world,
  indistinguishable lambda W W' -> isomorphic (rooted (@start W)) (rooted (@start W')).

Definition rigid (A : eqType) (lambda : sensor A) (W : lighthouse_world) := forall x y : W,
  indistinct (percept_by lambda (W := W)) (percept_by lambda (W := W)) x y -> x = y.

Definition coarser A B (lambda : sensor A) (mu : sensor B) :=
  forall (G : combinatorial_map) (r x : G) (H : combinatorial_map) (s y : H),
  degree x = degree y -> mu G r x = mu H s y -> lambda G r x = lambda H s y.
Definition strictly_coarser A B (lambda : sensor A) (mu : sensor B) :=
  coarser lambda mu /\ ~ coarser mu lambda.

Definition minimal A (lambda : sensor A) := sufficient lambda /\
  forall B (mu : sensor B), strictly_coarser mu lambda -> ~ sufficient mu.

Lemma sufficient_finer A B (lambda : sensor A) (mu : sensor B) : coarser lambda mu ->
  sufficient lambda -> sufficient mu.
Proof.
move=> C S W W' [R [Ro Rs Ra R0]]; apply: S; exists R; split=> // x y /Ro[D E].
by congr (_, _) => //; exact: C.
Qed.

(* ---- Sensors at v0 ---- *)
Definition at_v0 (w : nat -> nat -> nat) : sensor nat := fun G r x =>
  if at_same_vertex x r then w (degree x) (findex sigma x r) else 0.
Definition word (w : nat -> nat -> nat) d := mkseq (w d) d.
Definition adequate u := primitive u /\ ~~ blank u.

Definition position_word (d b : nat) := 1.
Definition directional_word (d b : nat) := b.+1.
Definition door_word (d b : nat) : nat := b == 0.
Definition half_word (d b : nat) := if b.*2 < d then 1 else 2.
Definition distance_word (d b : nat) := (minn b (d - b)).+1.
Definition remainder_word q (d b : nat) := (b %% q).+1.

(* the bearing is that of Model.v *)
Lemma letter_of_bearing w (W : lighthouse_world) (x : W) :
  at_v0 w pointed x = if bearing x is Some b then w (degree x) b else 0.
Proof. by rewrite /at_v0 /bearing; case: ifP. Qed.

Lemma bearing_turn (G : combinatorial_map) (r x : G) b : iter b sigma x = r ->
  findex sigma x r = b %% degree x.
Proof. by rewrite -turn_modulo_degree => <-; rewrite findex_iter // ltn_pmod // degree_gt0. Qed.

Lemma letter_turn w (G : combinatorial_map) (r x : G) b : iter b sigma x = r ->
  at_v0 w r x = w (degree x) (b %% degree x).
Proof. by move=> E; rewrite /at_v0 (bearing_turn E) -E [at_same_vertex _ _]fconnect_iter. Qed.

Lemma not_blank_at_v0 w (G : combinatorial_map) (r x : G) : at_v0 w r x != 0 -> at_same_vertex x r.
Proof. by rewrite /at_v0; case: ifP. Qed.

Theorem at_v0_invariant w : invariant (at_v0 w).
Proof.
move=> G H f [fb fs fa] r x; rewrite /at_v0 same_at_vertex // same_degree //; case: ifP => // c.
rewrite (@bearing_turn _ _ _ (findex sigma x r)) ?same_degree ?modn_small //; first exact: findex_max.
by rewrite -same_turn // iter_findex.
Qed.

(* ---- Adequate words ---- *)
Section Alike.
Variables (w : nat -> nat -> nat) (W W' : lighthouse_world).
Local Notation senses := (percept_by (at_v0 w)).
Local Notation alike := (indistinct (@senses W) (@senses W')).

(* if darts of v0 look alike that see the door at bearings b and b', the word does not change as it is
   turned by b' - b *)
Lemma alike_turned x y b b' : alike x y -> iter b sigma x = pointed -> iter b' sigma y = pointed ->
  forall c, w (degree x) ((c + b) %% degree x) = w (degree x) ((c + b') %% degree x).
Proof.
move=> A Eb Eb' c; have [D _] := indistinct_senses A; set d := degree x in D *; set j := d.-1 * c.
have full (G : combinatorial_map) (z r : G) i : degree z = d -> iter i sigma z = r ->
    at_v0 w r (iter j sigma z) = w d ((c + i) %% d).
  move=> Dz E; have Dj : degree (iter j sigma z) = d by rewrite (degree_same (fconnect_iter _ _ _)).
  rewrite (@letter_turn _ _ r _ (c + i)) ?Dj // -iterD.
  have -> : c + i + j = i + d * c by rewrite addnAC addnC /j -mulSn prednK ?degree_gt0.
  by rewrite iterD -(turn_modulo_degree (d * c)) Dz modnMr.
have [_ E] := indistinct_senses (indistinct_turn j A).
by rewrite -(full _ _ _ _ erefl Eb) -(full _ _ _ _ (esym D) Eb').
Qed.

(* what looks alike at v0 has one bearing *)
Lemma alike_bearing x y : primitive (word w (degree x)) -> alike x y ->
  at_same_vertex x pointed -> at_same_vertex y pointed ->
  findex sigma x pointed = findex sigma y pointed.
Proof.
move=> Pr A cx cy; have [D _] := indistinct_senses A.
apply: (primitive_turn Pr); first exact: findex_max.
  by rewrite D; exact: findex_max.
exact: (alike_turned A (iter_findex cx) (iter_findex cy)).
Qed.
End Alike.

(* in a world whose word is adequate no two darts look alike *)
Lemma adequate_rigid w (W : lighthouse_world) : adequate (word w (degree (@start W))) ->
  rigid (at_v0 w) W.
Proof.
rewrite /rigid; case=> Pr /allPn[l]; set d := degree _ in Pr *; set alike := indistinct _ _.
rewrite /word => /(nthP 0)[b]; rewrite size_mkseq => bd; rewrite nth_mkseq // => <- nb.
have Dp : degree (@pointed W) = d by rewrite (degree_same (@pointed_at_v0 W)).
pose x0 : W := iter (d - b) sigma pointed; have E0 : iter b sigma x0 = pointed.
  by rewrite /x0 -iterD subnKC ?(ltnW bd) // -Dp iter_degree.
have D0 : degree x0 = d by rewrite (degree_same (fconnect_iter _ _ _)).
have L0 : at_v0 w pointed x0 != 0 by rewrite (letter_turn w E0) D0 modn_small.
have one y : alike x0 y -> y = x0.
  move=> A; have [_ E] := indistinct_senses A; have c0 := not_blank_at_v0 L0.
  have c : at_same_vertex y pointed by apply: (@not_blank_at_v0 w); rewrite -E.
  have := alike_bearing (x := x0) _ A c0 c; rewrite D0 => /(_ Pr) B.
  by apply: (@iter_sigma_inj _ (findex sigma x0 pointed)); rewrite {1}B !iter_findex.
have k1 : #|class (percept_by (at_v0 w) (W := W)) x0| == 1.
  apply/cards1P; exists x0; apply/setP=> y; rewrite mem_class inE.
  by apply/idP/eqP=> [/one //|->]; exact: indistinct_refl.
move=> x y A; move: k1; rewrite (class_size _ x0 x) => /cards1P[z Z].
have mem u : alike x u -> u = z by move=> H; apply/set1P; rewrite -Z mem_class.
by rewrite (mem y A) (mem x) //; exact: indistinct_refl.
Qed.

(* ---- Where no two darts of a world look alike, it has no twin ---- *)
Lemma paired_isomorphic (G H : combinatorial_map) (x0 : G) (y0 : H) (R : G -> H -> bool) :
  R x0 y0 -> (forall x y, R x y -> R (sigma x) (sigma y)) -> (forall x y, R x y -> R (alpha x) (alpha y)) ->
  (forall x y y', R x y -> R x y' -> y = y') -> (forall x x' y, R x y -> R x' y -> x = x') ->
  isomorphic (rooted x0) (rooted y0).
Proof.
move=> R0 Rs Ra right_one left_one.
have some (x : G) : exists y, R x y.
  apply: (everywhere (A := fun x => exists y, R x y) (d := x0)) x => [|x [y /Rs]|x [y /Ra]]; last 2 first.
  - by exists (sigma y).
  - by exists (alpha y).
  by exists y0.
have some' (y : H) : exists x, R x y.
  apply: (everywhere (A := fun y => exists x, R x y) (d := y0)) y => [|y [x /Rs]|y [x /Ra]]; last 2 first.
  - by exists (sigma x).
  - by exists (alpha x).
  by exists x0.
pose f x := xchoose (some x); pose g y := xchoose (some' y).
have fP x : R x (f x) by exact: (xchooseP (some x)).
have gP y : R (g y) y by exact: (xchooseP (some' y)).
exists f, g; split=> /= [x _|y _|]; last exact: right_one (fP _) R0.
  split=> //; first exact: left_one (gP _) (fP _).
    by apply: right_one (fP _) _; exact: Rs.
  by apply: right_one (fP _) _; exact: Ra.
by split=> //; exact: right_one (fP _) (gP _).
Qed.

Section Rigid.
Variables (A : eqType) (lambda : sensor A) (W W' : lighthouse_world).
Local Notation sW := (percept_by lambda (W := W)).
Local Notation sW' := (percept_by lambda (W := W')).

Lemma indistinguishable_starts : indistinguishable lambda W W' -> indistinct sW sW' start start.
Proof.
case=> R [Ro Rs Ra R0]; apply/(indistinct_alikeP sW sW' start start).
apply: (@bisimulation_alike _ (rooted start) (rooted start) sW sW' R) => // x y Rxy.
by split=> //; exact: Ro.
Qed.

Theorem rigid_isomorphic : rigid lambda W -> rigid lambda W' -> indistinguishable lambda W W' ->
  isomorphic (rooted (@start W)) (rooted (@start W')).
Proof.
move=> Rg Rg' /indistinguishable_starts I; pose R := indistinct sW sW'.
have pick x y : R x y -> forall v, percepts_in (M := rooted (@start W)) sW v x
    = percepts_in (M := rooted (@start W')) sW' v y by case/(indistinct_alikeP sW sW' start start).
apply: (paired_isomorphic (R := R)) => // [x y|x y|x y y'|x x' y].
- exact: indistinct_sigma.
- exact: indistinct_alpha.
- by move=> /pick E /pick E'; apply: Rg'; apply/(indistinctP sW' start) => v; rewrite -E E'.
by move=> /pick E /pick E'; apply: Rg; apply/(indistinctP sW start) => v; rewrite E E'.
Qed.
End Rigid.

(* ---- Theorem 1, if ---- *)
Theorem adequate_suffices w (W W' : lighthouse_world) : adequate (word w (degree (@start W))) ->
  indistinguishable (at_v0 w) W W' ->
  isomorphic (rooted (@start W)) (rooted (@start W')) /\ first_bearing W = first_bearing W'.
Proof.
move=> Ad I; have A := indistinguishable_starts I; have [D _] := indistinct_senses A; split.
  by apply: rigid_isomorphic I; apply: adequate_rigid; rewrite // -D.
by have [Pr _] := Ad; exact: (alike_bearing Pr A (@pointed_at_v0 W) (@pointed_at_v0 W')).
Qed.
