(* ---------------------------------------------------------------------------------------------
   Without position: trees, and only trees, can be explored.                            Section III

   In a tree the robot can tell from its own motions where it is: a way that does not turn back does not
   return (dead reckoning).  So it can sense in its mind the lighthouse that is not there, and run
   Algorithm 1.  DoubleCover.v has the other half: every world with a cycle has a twin.

     acyclic G            no edge of G lies on a cycle.
     beyond e y           y is reached from the far end of e without using e.
     straight x y         y leaves the vertex that x leads to, and is not the way back.
     way_in tr x          the list tr is a way from the start to the vertex of x, which it enters by x: for
                          each vertex on the way, the last first, by which dart it is left, counted from
                          the dart by which it was entered, and its degree.
     reckoning            such a way, the turn from the dart by which the robot has entered to the dart
                          that it is in, and the degree there;  reckon: how a motion changes it.
     imagined             the percept of a directional lighthouse at the start.
     without_position Y   the explorer that senses degrees, and does what Y does with the imagined ones.

     tree_explored        Algorithm 1 so used is right in every tree.
     tree_iff_no_twin     a world is a tree if and only if every world that no motions tell from it, by
                          degrees, is the same.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Indistinguishable Algorithm.
From Allworlds Require Import Refinement DoubleCover.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- A way that does not turn back ---- *)
Section Straight.
Variable G : combinatorial_map.
Implicit Types x y e d : G.

Definition acyclic := forall e, ~~ on_cycle e.
Definition beyond e y := connect (step_without_e e) (alpha e) y.
Definition straight x y := at_same_vertex (alpha x) y && (y != alpha x).

Lemma step_turn e x y z : connect (step_without_e e) x y -> at_same_vertex y z ->
  connect (step_without_e e) x z.
Proof.
move=> c /iter_findex <-; elim: (findex _ _ _) => // k IH; apply: connect_trans IH (connect1 _).
by rewrite /step_without_e eqxx.
Qed.

Lemma step_cross e x y : connect (step_without_e e) x y -> ~~ crosses e y ->
  connect (step_without_e e) x (alpha y).
Proof. by move=> c n; apply: connect_trans c (connect1 _); rewrite /step_without_e eqxx n orbT. Qed.

(* what holds of a dart and is kept along the steps holds of what is reached *)
Lemma reached_ind (e : rel G) x (P : G -> Prop) : P x ->
  (forall u v, connect e x u -> P u -> e u v -> P v) -> forall y, connect e x y -> P y.
Proof.
move=> Px step y /connectP[p]; elim/last_ind: p y => [|p z IH] y; first by move=> _ ->.
rewrite rcons_path last_rcons => /andP[H S] ->; apply: (step (last x p)) => //; last exact: IH.
by apply/connectP; exists p.
Qed.

Hypothesis tree : acyclic.

(* beyond the next edge lies less than beyond this one *)
Lemma beyond_next x y : straight x y -> ~~ beyond y (alpha x) /\ (forall z, beyond y z -> beyond x z).
Proof.
case/andP=> c ne; have far : ~~ beyond y (alpha x).
  by apply: contra (tree y) => b; exact: step_turn b c.
have off z : beyond y z -> ~~ crosses x z.
  move=> b; apply/negP=> /orP[]/eqP E; rewrite E in b; last by rewrite b in far.
  case: (boolP (crosses y x)) => [/orP[]/eqP E'|n]; last by case/negP: far; exact: step_cross.
    by rewrite E' in b; case/negP: (tree y).
  by case/negP: ne; rewrite E' alphaK.
split=> // z; apply: (@reached_ind (step_without_e y) (alpha y) (beyond x)) => [|u v b IH].
  apply: step_cross; first by apply: step_turn c; exact: connect0.
  rewrite /crosses (negbTE ne) orbF; apply/eqP=> E; case/negP: (tree x); rewrite E in c.
  by apply: step_turn c; exact: connect0.
case/orP=> [/eqP->|/andP[/eqP-> _]]; first by apply: step_turn IH _; exact: fconnect1.
by apply: step_cross => //; exact: off.
Qed.

(* so such ways end *)
Lemma straight_ends x s : path straight x s -> size s < #|G|.
Proof.
suff H : path straight x s -> size s < #|[pred z | beyond x z]|.
  by move/H/leq_trans; apply; exact: max_card.
elim: s x => [|y s IH] x /=.
  by move=> _; apply/card_gt0P; exists (alpha x); exact: connect0.
case/andP=> S /IH lt; have [far sub] := beyond_next S; apply: leq_ltn_trans lt _; apply: proper_card.
apply/properP; split; first by apply/subsetP=> z; rewrite !inE; exact: sub.
by exists (alpha x); rewrite !inE // /beyond connect0.
Qed.
End Straight.

(* ---- Dead reckoning ---- *)
Record reckoning := Reckoning { way : seq (nat * nat); turned : nat; degree_here : nat }.

(* leave by motion k, arrive where the degree is n *)
Definition reckon (r : reckoning) k n :=
  let p := (turned r + k) %% degree_here r in
  if (p == 0) && (way r != [::]) then
    let: (q, _) := head (0, 0) (way r) in Reckoning (behead (way r)) q n
  else Reckoning ((p, degree_here r) :: way r) 0 n.

Definition imagined (r : reckoning) : percept :=
  let n := degree_here r in
  (n, if way r == [::] then Some ((n - turned r %% n) %% n) else None).

Section WithoutPosition.
Variables (E : Type) (Y : explorer percept E).

Definition advance (known : seq percept * reckoning) n :=
  if Y known.1 is Move k then
    let r := reckon known.2 k n in (rcons known.1 (imagined r), r)
  else known.
Definition known_after (seen : seq nat) :=
  let first := Reckoning [::] 0 (head 0 seen) in
  foldl advance ([:: imagined first], first) (behead seen).
Definition without_position : explorer nat E := fun seen => Y (known_after seen).1.
End WithoutPosition.

Section InATree.
Variables (G : combinatorial_map) (d0 : G).
Hypothesis tree : acyclic G.

Fixpoint way_in (tr : seq (nat * nat)) (x : G) : Prop :=
  if tr is (q, n) :: tr' then
    exists x', let y := iter q sigma x' in
    [/\ n = degree x', x = alpha y, tr' != [::] -> y != x' & way_in tr' x']
  else x = d0.

Lemma way_leaves tr x : way_in tr x -> tr != [::] -> ~~ beyond (alpha x) d0.
Proof.
elim: tr x => [|[q n] tr IH] x //= [x' [_ -> st W] _]; rewrite alphaK; set y := iter q sigma x' in st *.
have c : at_same_vertex x' y by exact: fconnect_iter.
case: (eqVneq tr [::]) => [t0|t0].
  rewrite t0 /= in W; apply: contra (tree y) => b; apply: step_turn b _.
  by rewrite -W.
have S : straight (alpha x') y by rewrite /straight alphaK c st.
have [_ sub] := beyond_next tree S; apply: contra (IH _ W t0); exact: sub.
Qed.

Lemma way_at_home tr x : way_in tr x -> at_same_vertex x d0 = (tr == [::]).
Proof.
move=> W; apply/idP/eqP=> [c|t0]; last by rewrite t0 /= in W; rewrite W; exact: connect0.
apply/eqP/negPn/negP=> t0; case/negP: (way_leaves W t0).
by rewrite /beyond alphaK; apply: step_turn c; exact: connect0.
Qed.

Definition tracks r (d : G) := exists x,
  [/\ way_in (way r) x, iter (turned r) sigma x = d & degree_here r = degree x].

Lemma reckon_tracks r k d : tracks r d -> tracks (reckon r k (degree (motion k d))) (motion k d).
Proof.
case: r => tr c n [x [/= W T ->]]; rewrite /reckon /=; set p := _ %% _.
have M : motion k d = alpha (iter p sigma x) by rewrite /motion -T -iterD addnC turn_modulo_degree.
case: ifP => [/andP[/eqP p0]|H].
  case: tr W => [|[q m] tr] //= [x' [mE xE st W]] _.
  exists x'; rewrite M p0 /= xE alphaK; split=> //; apply: degree_same; exact: fconnect_iter.
exists (motion k d); split=> //; rewrite M; exists x; split=> // t0.
move: H; rewrite t0 andbT => /negbT p0; apply: contra p0 => /eqP F.
have lp : p < degree x by rewrite ltn_mod degree_gt0.
by have := findex_iter lp; rewrite F findex0 => <-.
Qed.

Definition lit_tree := @LighthouseWorld G d0 d0 (connect0 _ d0).

Lemma imagined_percept r d : tracks r d -> imagined r = percept_of (d : lit_tree).
Proof.
case: r => tr c n [x [/= W T ->]]; have cx : at_same_vertex x d by rewrite -T; exact: fconnect_iter.
rewrite /imagined /percept_of /bearing /= (degree_same cx); congr (_, _).
have -> : at_same_vertex d d0 = (tr == [::]).
  by rewrite -(way_at_home W) /at_same_vertex (same_connect (fconnect_sym sigma_inj) cx).
case: eqP => // t0; rewrite t0 /= in W; congr Some; rewrite -W -T.
set y := iter _ sigma x.
set n' := degree x; have dy : degree y = n' by apply: degree_same; exact: fconnect_iter.
have F : iter ((n' - c %% n') %% n') sigma y = x.
  by rewrite -dy turn_modulo_degree dy; exact: opposite_turn.
by rewrite -[X in findex _ _ X]F findex_iter // -/(degree y) dy ltn_mod degree_gt0.
Qed.

Variables (E : Type) (Y : explorer percept E).

Lemma explore_tree fuel seen d ps r : known_after Y (degree d0 :: seen) = (ps, r) -> tracks r d ->
  let R := explore Y (rooted (@start lit_tree)) (@percept_of lit_tree) fuel ps d in
  exists t, explore (without_position Y) (rooted d0) (@degree G) fuel (degree d0 :: seen) d
    = (t, R.1.2, R.2).
Proof.
elim: fuel seen d ps r => [|fuel IH] seen d ps r K T; rewrite /= /without_position K /=.
  by case: (Y ps) => *; exists [::].
case A: (Y ps) => [k|a] /=; last by exists [::].
set d' := alpha _; have T' : tracks (reckon r k (degree d')) d' by exact: reckon_tracks.
have K' : known_after Y (degree d0 :: rcons seen (degree d')) =
    (rcons ps (percept_of (d' : lit_tree)), reckon r k (degree d')).
  move: K; rewrite /known_after /= -cats1 foldl_cat => -> /=.
  by rewrite /advance /= A -(imagined_percept T').
have [t R] := IH _ _ _ _ K' T'; rewrite -/(without_position Y) in R *.
by rewrite R; case: (explore Y _ _ _ _ _) => [[t' e'] z']; eexists.
Qed.
End InATree.

Theorem tree_explored pol (G : combinatorial_map) (d : G) : acyclic G ->
  right denote (without_position (algorithm1 pol)) (rooted d) (@degree_sensed G).
Proof.
move=> tree; pose W := lit_tree d; have [n [t [e [z [R We I]]]]] := algorithm1_right W pol.
have T : tracks d (Reckoning [::] 0 (degree d)) d by exists d.
have K : known_after (algorithm1 pol) [:: degree d] =
    ([:: percept_of (@start W)], Reckoning [::] 0 (degree d)).
  by rewrite /known_after /= (imagined_percept tree T).
have [t' R'] := explore_tree tree n K T; rewrite /episode /= in R; rewrite R in R'.
by exists n, t', e, z.
Qed.

(* ---- A world that no motions tell from a tree is that tree ---- *)

(* round a cycle without turning back *)
Lemma reduced (G : combinatorial_map) (e a b : G) : connect (step_without_e e) a b ->
  exists s, all (fun x => ~~ crosses e x) s /\
    (if s is x :: s' then [/\ at_same_vertex a x, path (@straight G) x s' &
       at_same_vertex (alpha (last x s')) b] else at_same_vertex a b).
Proof.
have sym (x y : G) : at_same_vertex x y -> at_same_vertex y x by rewrite at_same_vertex_sym.
case/connectP=> p; elim: p a => [|c p IH] a /=.
  by move=> _ ->; exists [::]; split=> //; exact: connect0.
case/andP=> /orP[/eqP->|/andP[/eqP-> na]] P L; have [s [As Hs]] := IH _ P L.
  exists s; split=> //; have c1 : at_same_vertex a (sigma a) by exact: fconnect1.
  case: s Hs {As} => [|x s] H; first exact: connect_trans c1 H.
  by case: H => H ? ?; split=> //; exact: connect_trans c1 H.
case: s As Hs => [|x s] /= As Hs; first by exists [:: a]; rewrite /= na; do 2 split=> //; exact: connect0.
have [c1 S c2] := Hs; case/andP: (As) => nx As'; case: (x =P alpha a) => [xE|/eqP ne]; last first.
  by exists [:: a, x & s]; rewrite /= na nx As' /straight c1 ne; do 2 split=> //; exact: connect0.
exists s; split=> //; case: s S c2 As' {As Hs} => [|y s] /=; rewrite xE /straight alphaK //.
by case/andP=> /andP[c3 _] S c2 _.
Qed.

Lemma cycle_straight (G : combinatorial_map) (e : G) : on_cycle e ->
  exists s, path (@straight G) e (rcons s e).
Proof.
case/reduced=> -[|x s] [A H]; first by exists [::]; rewrite /= /straight H eq_sym alpha_neq.
have /andP[nx _] := A; have [c S c'] := H; exists (x :: s).
have nl : ~~ crosses e (last x s) by exact: (allP A _ (mem_last x s)).
rewrite /= rcons_path S /straight c c' /=; apply/andP; split.
  by apply: contra nx => /eqP->; rewrite /crosses eqxx orbT.
by apply: contra nl => /eqP E; rewrite /crosses E alphaK eqxx orbT.
Qed.

Lemma twin_of_a_tree (G H : combinatorial_map) (d : G) (d' : H) : acyclic G ->
  alike (M := rooted d) (N := rooted d') (@degree G) (@degree H) d d' -> acyclic H.
Proof.
move=> tree A e; apply/negP=> cyc.
pose R := alike (M := rooted d) (N := rooted d') (@degree G) (@degree H).
have WG := rooted_wellformed d; have WH := rooted_wellformed d'.
have turn k x y : R x y -> R (iter k sigma x) (iter k sigma y).
  by move=> r; elim: k => //= k; exact: (alike_sigma WG WH).
have follow x y s : R x y -> path (@straight H) y s ->
    exists s', path (@straight G) x s' /\ size s' = size s.
  elim: s x y => [|y' s IH] x y r /=; first by exists [::].
  case/andP=> /andP[c ne] P; pose k := findex sigma (alpha y) y'.
  have r1 := turn k _ _ (alike_alpha WG WH r); rewrite /= iter_findex // in r1.
  have [s' [P' sz]] := IH _ _ r1 P; exists (iter k sigma (alpha x) :: s'); rewrite /= P' sz andbT.
  split=> //; rewrite /straight /at_same_vertex fconnect_iter; apply: contra ne => /eqP F.
  have D : degree (alpha x) = degree (alpha y) by exact: (alike_percept (alike_alpha WG WH r)).
  have lk : k < degree (alpha x) by rewrite D; exact: findex_max.
  by rewrite -(iter_findex c) -/k; have := findex_iter lk; rewrite F findex0 => <-.
have [x0 r0] : exists x0, R x0 e.
  apply: (@everywhere H (fun y => exists x, R x y) d') => [|y [x r]|y [x r]]; first by exists d.
    by exists (sigma x); exact: (alike_sigma WG WH).
  by exists (alpha x); exact: (alike_alpha WG WH).
have [s P] := cycle_straight cyc.
have long n : exists s', [/\ path (@straight H) e s', n <= size s' & last e s' = e].
  elim: n => [|n [s' [P' sz l]]]; first by exists [::].
  exists (s' ++ rcons s e); rewrite cat_path P' l P size_cat size_rcons last_cat last_rcons; split=> //.
  by rewrite addnS ltnS (leq_trans sz) ?leq_addr.
have [s1 [P1 sz _]] := long #|G|; have [s2 [P2 sz2]] := follow _ _ _ r0 P1.
by have := straight_ends tree P2; rewrite sz2 ltnNge sz.
Qed.

Theorem tree_iff_no_twin (G : combinatorial_map) (d : G) : acyclic G <->
  forall (H : combinatorial_map) (d' : H),
  (forall w, percepts_in (M := rooted d) (@degree G) w d
           = percepts_in (M := rooted d') (@degree H) w d') ->
  isomorphic (rooted d) (rooted d').
Proof.
split=> [tree H d' same|no_twin e].
  have A : alike (M := rooted d) (N := rooted d') (@degree G) (@degree H) d d' by [].
  have WG := rooted_wellformed d; have WH := rooted_wellformed d'.
  pose pol := Policy (fun _ => (0, 0)) (fun _ _ => [::]) (fun _ _ hs => hs) (fun _ _ => [::]).
  apply: (@twins_impossible _ _ denote (without_position (algorithm1 pol)) (rooted d) (rooted d')
    (@degree G) (@degree H) (alike (M := rooted d) (N := rooted d') (@degree G) (@degree H))) => //.
  - by move=> x y; exact: (@alike_percept _ (rooted d) (rooted d')).
  - by move=> x y; exact: (alike_sigma WG WH).
  - by move=> x y; exact: (alike_alpha WG WH).
  - exact: tree_explored.
  exact: tree_explored (twin_of_a_tree tree A).
apply/negP=> cyc; pose H := double_cover cyc.
have I : isomorphic (rooted d) (rooted ((d, false) : H)).
  have same w : forall x t, percepts_in (M := rooted d) (@degree G) w x =
      percepts_in (M := rooted ((d, false) : H)) (@degree H) w (x, t).
    elim: w => [|k w IH] x t /=; rewrite degree_in_cover //; congr (_ :: _).
    by rewrite (IH _ (t (+) crosses e (iter k sigma x))) /motion_in /= (turn_in_cover cyc).
  by apply: no_twin => w; exact: same.
have := same_map_edges (isomorphic_same_map (rooted_wellformed d) I).
rewrite cover_edges -addnn -{1}[edges G]addn0 => /addnI /esym e0.
by have := edges_gt0 d; rewrite e0.
Qed.
