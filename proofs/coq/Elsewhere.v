(* ---------------------------------------------------------------------------------------------
   A robot that starts elsewhere: it looks for v0, and there an explorer begins.  Sections II.B, VIII

   The robot may start at any dart of the world, and does not know where v0 is.  It tries all words of
   motions, of one, two, three ... motions, and takes each back; the way back is known by the edge by
   which it has come.

     shown o              the marker is seen.
     round deeper left due    leave by one dart of a vertex after the other, left of them; look; try what
                          `deeper` tries behind it; come back.  due: the turn after which the robot stands
                          as if it had just come in.
     tried L n due        all words of at most L motions, at a vertex with n darts: the percept at v0, if
                          one leads there; else the turn that is due, at the same vertex.
     quest                Searching L p: words of at most L motions are tried, p is to be done;
                          Found seen: v0 was found, and this was sensed from there on.
     elsewhere X          the explorer that looks for v0 so, and there begins with X.
     tree_cost D L, search_cost D L   what trying all words of at most L motions costs, if no vertex has
                          more than D darts; the same for at most 1, 2, ..., L motions.
     near_v0 L x          some word of at most L motions leads from x to v0.
     tried_makes          the program does what it should.
     search_finds         wherever the robot starts it finds v0, and X begins there.
     elsewhere_finds      so it does in every world, from every dart.
     elsewhere_right      if X is right from v0, elsewhere X is right from every dart.
     elsewhere_algorithm1 Algorithm 1 there: what it costs in all.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import Lia.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Algorithm Execution Refinement.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The program ---- *)
Local Notation result := (option percept * nat)%type.
Definition shown (o : percept) := isSome o.2.

Fixpoint round (deeper : nat -> program percept result) left due : program percept result :=
  if left is left'.+1 then
    Go due (fun o =>
      if shown o then Return (Some o, 0)
      else bind (deeper o.1) (fun r =>
        if r.1 then Return r else Go r.2 (fun _ => round deeper left' 1)))
  else Return (None, due).
Fixpoint tried L n due : program percept result :=
  if L is L'.+1 then round (fun n' => tried L' n' 0) n due else Return (None, due).

Inductive quest := Searching (L : nat) (p : program percept result) | Found (seen : seq percept).

(* n: the degree of the vertex where it starts *)
Definition settled n L (p : program percept result) :=
  match p with
  | Go _ _ => Searching L p
  | Return (Some o, _) => Found [:: o]
  | Return (None, due) => Searching L.+1 (tried L.+1 n due)
  end.
Definition hear n q (o : percept) :=
  match q with
  | Found seen => Found (rcons seen o)
  | Searching L (Go _ f) => settled n L (f o)
  | Searching _ (Return _) => q
  end.
Definition quest_of seen :=
  if seen is o :: seen' then
    foldl (hear o.1) (settled o.1 0 (Return (if shown o then Some o else None, 0))) seen'
  else Found [::].
Definition elsewhere E (X : explorer percept E) : explorer percept E := fun seen =>
  match quest_of seen with
  | Found seen' => X seen'
  | Searching _ (Go k _) => Move k
  | Searching _ (Return _) => Move 0
  end.

(* ---- What it costs ---- *)
Fixpoint tree_cost D L := if L is L'.+1 then D * (2 + tree_cost D L') else 0.
Fixpoint search_cost D L := if L is L'.+1 then search_cost D L' + tree_cost D L else 0.

Lemma tree_cost_le D L : 1 < D -> tree_cost D L + 4 <= 4 * D ^ L.
Proof.
move=> D1; elim: L => [|L IH] //=; rewrite expnS; move: (D ^ L) IH => x /leP IH; apply/leP.
by move/ltP: D1 => D1; move: IH; rewrite -!(plusE, multE); nia.
Qed.

Theorem search_cost_le D L : 1 < D -> search_cost D L + 8 <= 8 * D ^ L.
Proof.
move=> D1; elim: L => [|L IH] //; have := tree_cost_le L.+1 D1.
rewrite [search_cost _ _.+1]/= -/(tree_cost D L.+1) expnS; move: (tree_cost D L.+1) (D ^ L) IH => c x /leP IH /leP H.
by apply/leP; move/ltP: D1 => D1; move: IH H; rewrite -!(plusE, multE); nia.
Qed.

Section InWorld.
Variables (W : lighthouse_world) (D : nat).
Hypothesis degrees_le : forall d : W, degree d <= D.
Local Notation v0 := (@start W).
Local Notation senses := (@percept_of W).
Local Notation exec := (exec senses).
Local Notation makes := (makes senses).
Implicit Types (d x y z : W) (w : seq nat).

Definition near_v0 L x := exists2 w, size w <= L & at_same_vertex v0 (walk w x).

Lemma shown_at_v0 d : shown (percept_of d) = at_same_vertex v0 d.
Proof.
rewrite /shown /= /bearing at_same_vertex_sym /at_same_vertex.
by rewrite (same_connect (fconnect_sym sigma_inj) (@pointed_at_v0 W)); case: ifP.
Qed.

(* what the search comes to; L: the words that were tried at y *)
Definition outcome (r : result) z (missed : Prop) :=
  if r.1 is Some o then o = percept_of z /\ at_same_vertex v0 z else missed.

Lemma motion_modulo k x : motion (k %% degree x) x = motion k x.
Proof. by rewrite /motion turn_modulo_degree. Qed.

Lemma tried_makes L n due d y : n = degree y -> iter due sigma d = y ->
  exists r z c, [/\ makes (tried L n due) d r z c, c <= tree_cost D L &
    outcome r z (iter r.2 sigma z = y /\ forall w, 0 < size w <= L -> ~~ at_same_vertex v0 (walk w y))].
Proof.
move=> ->; elim: L due d y => [|L IH] due d y dy.
  exists (None, due), d, 0; split=> //; first exact: makes_return.
  by split=> // w /andP[]; case: (size w).
have R left : forall due d y, iter due sigma d = y ->
    exists r z c, [/\ makes (round (fun n' => tried L n' 0) left due) d r z c,
      c <= left * (2 + tree_cost D L) &
      outcome r z (iter r.2 sigma z = iter left sigma y /\
        forall j w, j < left -> size w <= L -> ~~ at_same_vertex v0 (walk w (motion j y)))].
  elim: left => [|left IHl] due' d' y' dy'.
    by exists (None, due'), d', 0; split=> //; exact: makes_return.
  pose x := motion 0 y'; have m1 : motion due' d' = x by rewrite /x /motion dy'.
  have xK : alpha x = y' by rewrite /x /motion /= alphaK.
  case S: (shown (percept_of x)).
    exists (Some (percept_of x), 0), x, 1; split; last by split=> //; rewrite -shown_at_v0.
      by rewrite /=; apply: makes_go; rewrite m1 S; exact: makes_return.
    by rewrite mulSn.
  have [r [z [c [M le O]]]] := IH 0 x x (erefl x).
  case r1: r.1 O => [o|] O.
    exists r, z, c.+1; split; last by rewrite /outcome r1 in O *.
      rewrite /=; apply: makes_go; rewrite m1 S -[c]addn0; apply: (makes_bind M).
      by rewrite r1; exact: makes_return.
    by rewrite mulSn; apply: leq_trans (leq_addr _ _); exact: leqW.
  move: O; rewrite /outcome r1 => -[back missed].
  have m2 : motion r.2 z = y' by rewrite /motion back.
  have [r' [z' [c' [M' le' O']]]] := IHl 1 y' (sigma y') (erefl _).
  exists r', z', (c + c'.+1).+1; split.
  - rewrite /=; apply: makes_go; rewrite m1 S; apply: (makes_bind M); rewrite r1.
    by apply: makes_go; rewrite m2.
  - by rewrite mulSn addnS -addnA !addSn add0n !ltnS leq_add.
  move: O'; rewrite /outcome; case: r'.1 => [o|] // [turned missed'].
  split; first by rewrite turned -iterSr.
  case=> [|j] w lj lw; last first.
    by have := missed' j w lj lw; rewrite /motion -iterSr.
  case: w lw => [|k w] lw; first by rewrite -shown_at_v0 -/x S.
  exact: missed.
have [r [z [c [M le O]]]] := R (degree y) _ _ _ dy; exists r, z, c; split=> //.
  by apply: leq_trans le _; rewrite leq_mul2r degrees_le orbT.
move: O; rewrite /outcome; case: r.1 => [o|] // [-> missed]; rewrite iter_degree; split=> // -[|k w] //= lw.
by rewrite -motion_modulo; apply: missed => //; rewrite ltn_mod degree_gt0.
Qed.

(* ---- The explorer ---- *)
Variables (E : Type) (X : explorer percept E) (x : W).
Local Notation Y := (elsewhere X).
Local Notation explore := (explore Y (rooted x) senses).

Lemma quest_rcons o seen o' : quest_of (rcons (o :: seen) o') = hear o.1 (quest_of (o :: seen)) o'.
Proof. by rewrite /= -cats1 foldl_cat. Qed.

Lemma searching L (p : program percept result) o seen d r z t :
  quest_of (o :: seen) = settled o.1 L p -> exec p d = (r, z, t) -> exists seen',
  quest_of (o :: seen') = settled o.1 L (Return r) /\
  forall budget, explore (size t + budget) (o :: seen) d =
    let: (t', e, z') := explore budget (o :: seen') z in (t ++ t', e, z').
Proof.
elim: p seen d t => [r'|k f IH] seen d t Q /=.
  by case=> <- <- <-; exists seen; split=> // budget; rewrite add0n; case: (explore _ _ _) => [[? ?] ?].
case F: (exec _ _) => [[r1 z1] t1] [rE zE <-]; subst r1 z1; set o' := senses (motion k d) in F *.
have Q' : quest_of (o :: rcons seen o') = settled o.1 L (f o') by rewrite -rcons_cons quest_rcons Q.
have [seen' [Qr R]] := IH o' (rcons seen o') _ _ Q' F; exists seen'; split=> // budget.
have Yk : Y (o :: seen) = Move k by rewrite /elsewhere Q.
rewrite [size _]/= addSn [LHS]/= Yk -[alpha _]/(motion k d) -/o' R.
by case: (Model.explore _ _ _ _ _ _) => [[? ?] ?].
Qed.

Lemma found_explores budget o seen found d : quest_of (o :: seen) = Found found ->
  explore budget (o :: seen) d = Model.explore X (rooted x) senses budget found d.
Proof.
elim: budget seen found d => [|n IH] seen found d Q /=; rewrite {1}/elsewhere Q; case: (X found) => // k.
by rewrite (IH _ (rcons found (senses (motion_in (rooted x) k d)))) // -rcons_cons quest_rcons Q.
Qed.

Lemma rounds j L due d o seen : o = senses x -> quest_of (o :: seen) = settled o.1 L (Return (None, due)) ->
  iter due sigma d = x -> ~~ at_same_vertex v0 x -> near_v0 (L + j) x ->
  (forall w, 0 < size w <= L -> ~~ at_same_vertex v0 (walk w x)) ->
  exists t z, [/\ at_same_vertex v0 z, search_cost D L + size t <= search_cost D (L + j) & forall budget,
    explore (size t + budget) (o :: seen) d =
    let: (t', e, z') := episode X (rooted z) senses budget in (t ++ t', e, z')].
Proof.
move=> oE; elim: j L due d seen => [|j IH] L due d seen Q dx n0 near missed.
  case: near => w; rewrite addn0 => lw; case: w lw => [|k w] lw v; first by case/negP: n0.
  by case/negP: (missed (k :: w) lw).
have [r [z [c [[t [F sz]] le O]]]] := tried_makes L.+1 (n := o.1) (etrans (congr1 fst oE) (erefl _)) dx.
have Q' : quest_of (o :: seen) = settled o.1 L.+1 (tried L.+1 o.1 due).
  by rewrite Q /= oE /=; case: (degree x) (degree_gt0 x).
have cost : size t <= tree_cost D L.+1 by rewrite sz.
have grows a b : search_cost D a <= search_cost D (a + b).
  by elim: b => [|b IHb]; rewrite ?addn0 // addnS; exact: leq_trans IHb (leq_addr _ _).
case r1: r.1 O => [o'|]; rewrite /outcome r1 => -[].
  move=> oz zv; exists t, z; split=> // [|budget].
    rewrite -addSnnS; apply: leq_trans (grows _ _); by rewrite [X in _ <= X]/= leq_add2l.
  have [seen' [Qr ->]] := searching Q' F; have rE : r = (Some o', r.2) by case: (r) r1 => ? ? /= ->.
  by rewrite rE oz in Qr; rewrite (found_explores budget z Qr).
move=> back missed'; rewrite -addSnnS in near *.
have [seen' [Qr Rr]] := searching Q' F; have rE : r = (None, r.2) by case: (r) r1 => ? ? /= ->.
rewrite rE in Qr; have [t' [z' [zv cost' R]]] := IH L.+1 r.2 z seen' Qr back n0 near missed'.
exists (t ++ t'), z'; split=> // [|budget].
  apply: leq_trans cost'; rewrite size_cat addnA leq_add2r [X in _ <= X]/= leq_add2l.
  exact: cost.
by rewrite size_cat -addnA Rr R; case: (episode _ _ _ _) => [[? ?] ?]; rewrite catA.
Qed.

Theorem search_finds L : near_v0 L x -> exists t z, [/\ at_same_vertex v0 z, size t <= search_cost D L &
  forall budget, episode Y (rooted x) senses (size t + budget) =
    let: (t', e, z') := episode X (rooted z) senses budget in (t ++ t', e, z')].
Proof.
move=> near; case: (boolP (at_same_vertex v0 x)) => [v|n0].
  have Q : quest_of [:: senses x] = Found [:: senses x] by rewrite /= shown_at_v0 v.
  exists [::], x; split=> // budget; rewrite /episode add0n (found_explores budget x Q).
  by case: (Model.explore _ _ _ _ _ _) => [[? ?] ?].
have Q : quest_of [:: senses x] = settled (senses x).1 0 (Return (None, 0)).
  by rewrite /= shown_at_v0 (negbTE n0).
have [|t [z [zv le R]]] := @rounds L 0 0 x (senses x) [::] (erefl _) Q (erefl _) n0 near; last first.
  by exists t, z.
by case.
Qed.
End InWorld.

(* some motions lead to v0 from everywhere *)
Lemma somewhere_near (W : lighthouse_world) (x : W) : exists L, near_v0 L x.
Proof.
suff [w v] : exists w, at_same_vertex (start : W) (walk w x) by exists (size w), w.
apply: (@everywhere W (fun x => exists w, at_same_vertex start (walk w x)) start).
- by exists [::]; exact: connect0.
- move=> y [[|k w] v]; first by exists [::]; apply: connect_trans v (fconnect1 _ _).
  exists (k + (degree y).-1 :: w); rewrite /= /motion -iterSr -addnS prednK ?degree_gt0 // iterD iter_degree.
  exact: v.
by move=> y [w v]; exists (0 :: w); rewrite /= /motion /= alphaK.
Qed.

Theorem elsewhere_finds (W : lighthouse_world) (x : W) E (X : explorer percept E) :
  exists t z, at_same_vertex (start : W) z /\ forall budget,
  episode (elsewhere X) (rooted x) (@percept_of W) (size t + budget) =
    let: (t', e, z') := episode X (rooted z) (@percept_of W) budget in (t ++ t', e, z').
Proof.
have [L near] := somewhere_near x; have le (d : W) : degree d <= #|W| by exact: max_card.
by have [t [z [v _ R]]] := search_finds le X near; exists t, z.
Qed.

Theorem elsewhere_right E (meaning : E -> rooted_map) (X : explorer percept E) :
  (forall W : lighthouse_world, right meaning X (rooted (@start W)) (@percept_of W)) ->
  forall (W : lighthouse_world) (x : W), right meaning (elsewhere X) (rooted x) (@percept_of W).
Proof.
move=> H W x; have [t [z [zv R]]] := elsewhere_finds x X.
have zp : at_same_vertex z (@pointed W).
  by rewrite at_same_vertex_sym in zv; exact: connect_trans zv (@pointed_at_v0 W).
have [n [t' [e [z' [R' wf I]]]]] := H (LighthouseWorld zp).
by exists (size t + n), (t ++ t'), e, z'; split=> //; rewrite R R'.
Qed.

Theorem elsewhere_algorithm1 (W : lighthouse_world) (pol : policy) D L (x : W) budget :
  (forall d : W, degree d <= D) -> near_v0 L x ->
  let bound := search_cost D L + paper_bound (vertices W) (edges W) in bound <= budget ->
  exists transcript answer z,
  [/\ episode (elsewhere (algorithm1 pol)) (rooted x) (@percept_of W) budget = (transcript, Some answer, z),
      size transcript <= bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> le near bound lb; have [t [z [zv ct R]]] := search_finds le (algorithm1 pol) near.
have zp : at_same_vertex z (@pointed W).
  by rewrite at_same_vertex_sym in zv; exact: connect_trans zv (@pointed_at_v0 W).
have lt : size t <= budget by apply: leq_trans lb; exact: leq_trans ct (leq_addr _ _).
have lp : paper_bound (vertices W) (edges W) <= budget - size t.
  by rewrite leq_subRL //; apply: leq_trans lb; rewrite leq_add2r.
have [t' [a [z' [R' ct' V I]]]] := @algorithm1_correct (LighthouseWorld zp) pol _ lp.
exists (t ++ t'), a, z'; split=> //; first by rewrite -(subnKC lt) R R'.
by rewrite size_cat; apply: leq_add.
Qed.
