(* ---------------------------------------------------------------------------------------------
   Sensors that look further than v0: six kinds of darts, by their place relative to the door, and which of
   the sensors that tell some of these kinds apart are rigid.

     feature r x          the kind of the dart x where the door is r: 3 the door; 2 the dart behind it; at v0, 4
                          the next one clockwise, 5 another; elsewhere, 1 at a neighbour of v0, 0 further away.
                          If the door is a loop, the dart behind it is 2, and not 4 or 5.
     coarsened c          the sensor that shows the letter c i for a dart of kind i.
     coarsened_invariant  it is a sensor.
   Three reasons, each a condition on the six letters, why no two indistinguishable worlds differ:
     reason_behind        the dart behind the door has a letter of its own.
     reason_edge          the door's letter is shown at v0 alone, that of the dart behind it is not shown there
                          nor at neighbours.
     reason_apart         none of ten sets of features share their letters (merged).
   In a world, if a reason holds:
     alone_rigid          if one dart has no lookalike, none has.
     behind_rigid, edge_rigid, big_rigid, two_rigid, two_next_rigid, leaf_rigid
                          so it is by the first two reasons; and by the third, where v0 has degree 3 or more, 2
                          (the door and the next dart with different letters, or with one), or 1, but for
     rigid_or             the worlds with one edge, and the path with 4 vertices, the door at the second (path_at).
     listed_isomorphic    a list of pairs of darts, closed under sigma and alpha, is an isomorphism;
     edge_isomorphic, paths_isomorphic   so these worlds are known by how they look.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Indistinguishable PositionTwins Ambiguity.
From Allworlds Require Import SameWorld Sensors.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Six kinds of darts ---- *)
Section Feature.
Variables (G : combinatorial_map) (r : G).
Implicit Types x y : G.

Definition near x := [exists y, at_same_vertex x y && at_same_vertex (alpha y) r].
Definition feature x : nat :=
  if x == r then 3 else if x == alpha r then 2
  else if at_same_vertex x r then if x == sigma r then 4 else 5 else near x.

Variant feature_spec x : nat -> Type :=
  | IsDoor of x = r : feature_spec x 3
  | IsBehind of x = alpha r : feature_spec x 2
  | IsNext of at_same_vertex x r & x = sigma r & x <> r & x <> alpha r : feature_spec x 4
  | IsOther of at_same_vertex x r & x <> r & x <> alpha r & x <> sigma r : feature_spec x 5
  | IsNeighbour of ~~ at_same_vertex x r & x <> alpha r & near x : feature_spec x 1
  | IsAway of ~~ at_same_vertex x r & x <> alpha r & ~~ near x : feature_spec x 0.

Lemma featureP x : feature_spec x (feature x).
Proof.
rewrite /feature; case: eqP => [->|nr]; first by constructor.
case: eqP => [->|nb]; first by constructor.
case: ifP => v; last by case n: (near x); constructor; rewrite ?n ?v.
by case: eqP => e; constructor.
Qed.

Lemma feature_lt6 x : feature x < 6.
Proof. by case: featureP. Qed.

Lemma vertex_sigma x y : at_same_vertex (sigma x) y = at_same_vertex x y.
Proof. exact/esym/(same_connect1 (fconnect_sym sigma_inj) (eqxx _)). Qed.

Lemma vertex_refl x : at_same_vertex x x.
Proof. exact: connect0. Qed.

Lemma near_sigma x : near (sigma x) = near x.
Proof. by apply: eq_existsb => y; rewrite vertex_sigma. Qed.

Lemma near_alpha x : at_same_vertex x r -> near (alpha x).
Proof. by move=> v; apply/existsP; exists (alpha x); rewrite alphaK v andbT vertex_refl. Qed.
End Feature.

Definition coarsened (c : nat -> nat) : sensor nat := fun G r x => c (feature r x).

Theorem coarsened_invariant c : invariant (coarsened c).
Proof.
move=> G H f [fb fs fa] r x; congr c; have fi := bij_inj fb; have v := same_at_vertex fb fs.
rewrite /feature -fa -fs !(inj_eq fi) v; do 3 case: ifP => // _; congr nat_of_bool.
have [g gf fg] := fb; apply/existsP/existsP=> -[y]; last by exists (f y); rewrite -fa !v.
by exists (g y); rewrite -!v fa fg.
Qed.

Lemma coarsened_coarser c c' : (forall i j, i < 6 -> j < 6 -> c' i = c' j -> c i = c j) ->
  coarser (coarsened c) (coarsened c').
Proof. by move=> H G r x K s y _; apply: H; exact: feature_lt6. Qed.

(* ---- Darts that have no lookalike ---- *)
Lemma fixed_degree (G : combinatorial_map) (x : G) : (sigma x == x) = (degree x == 1).
Proof.
apply/eqP/eqP=> [E|E]; last by have := iter_degree x; rewrite E.
by apply: order_least => //; [exact: sigma_inj | case].
Qed.

Lemma twice_degree (G H : combinatorial_map) (x : G) (y : H) : degree x = degree y ->
  sigma (sigma x) = x -> sigma (sigma y) = y.
Proof.
move=> D E; have: degree x <= 2.
  by apply: (@order_le_cycle _ _ [:: x; sigma x]); rewrite ?inE ?eqxx //= E !eqxx.
have := iter_degree y; rewrite -D; move: (degree_gt0 x); case: (degree x) => [|[|[|//]]] //= _.
by move=> F; rewrite !F.
Qed.

Lemma of_two (G : combinatorial_map) (x y : G) : sigma (sigma x) = x -> at_same_vertex x y ->
  y = x \/ y = sigma x.
Proof.
move=> E v; rewrite -(iter_findex v); elim: (findex _ _ _) => [|n [] IH] /=; first by left.
  by right; rewrite IH.
by left; rewrite IH.
Qed.

Lemma alone_rigid (A : eqType) (lambda : sensor A) (W : lighthouse_world) (x : W) :
  (forall y, indistinct (percept_by lambda (W := W)) (percept_by lambda (W := W)) x y -> y = x) ->
  rigid lambda W.
Proof.
set alike := indistinct _ _ => one; pose P y := forall z, alike y z -> z = y.
suff every : forall y, P y by move=> y z /every.
apply: (@everywhere W P x one) => y IH z.
  have <- : sigma (iter (degree z).-1 sigma z) = z by rewrite -iterS prednK ?degree_gt0 ?iter_degree.
  by move/(indistinct_unturn (j := 1))/IH ->.
by move/indistinct_alpha; rewrite alphaK => /IH <-; rewrite alphaK.
Qed.

(* ---- Small maps ---- *)
Lemma one_of_each (A B : eqType) (l : seq (A * B)) x y y' :
  uniq (unzip1 l) -> (x, y) \in l -> (x, y') \in l -> y = y'.
Proof.
elim: l => //= -[a e] l IH /andP[/negP na u]; rewrite !inE !xpair_eqE.
case/orP=> [/andP[/eqP-> /eqP->]|m]; case/orP=> [/andP[/eqP E /eqP->]|m'] //; last exact: IH.
  by case: na; apply/mapP; exists (a, y').
by case: na; apply/mapP; exists (x, y) => //=.
Qed.

Lemma listed_isomorphic (G H : combinatorial_map) (x : G) (y : H) (l : seq (G * H)) : (x, y) \in l ->
  all (fun p => ((sigma p.1, sigma p.2) \in l) && ((alpha p.1, alpha p.2) \in l)) l ->
  uniq (unzip1 l) -> uniq (unzip2 l) -> isomorphic (rooted x) (rooted y).
Proof.
move=> m /allP A u1 u2; pose R a e := (a, e) \in l.
apply: (paired_isomorphic (R := R)) => // [a e /A /andP[] //|a e /A /andP[] //|a e e'|a a' e].
  exact: one_of_each.
have sw u v : R u v -> (v, u) \in [seq (p.2, p.1) | p <- l] by move=> ?; apply/mapP; exists (u, v).
by move=> /sw H1 /sw; apply: one_of_each H1; rewrite /unzip1 -map_comp.
Qed.

Lemma edge_isomorphic (G H : combinatorial_map) (x : G) (y : H) :
  (sigma x = x /\ sigma (alpha x) = alpha x) /\ (sigma y = y /\ sigma (alpha y) = alpha y) \/
  (sigma x = alpha x /\ sigma (alpha x) = x) /\ (sigma y = alpha y /\ sigma (alpha y) = y) ->
  isomorphic (rooted x) (rooted y).
Proof.
move=> E; apply: (@listed_isomorphic _ _ _ _ [:: (x, y); (alpha x, alpha y)]); rewrite ?mem_head //=.
- by case: E => -[[-> ->] [-> ->]]; rewrite !alphaK !inE !eqxx ?orbT.
- by rewrite inE eq_sym alpha_neq.
by rewrite inE eq_sym alpha_neq.
Qed.

Section Path.
Variables (G : combinatorial_map) (x : G).
Definition path_darts := let t := alpha (sigma x) in [:: x; sigma x; t; sigma t; alpha (sigma t); alpha x].
Definition path_at := let t := alpha (sigma x) in
  [&& sigma x != x, sigma (sigma x) == x, sigma (alpha x) == alpha x,
      sigma t != t, sigma (sigma t) == t & sigma (alpha (sigma t)) == alpha (sigma t)].

Hypothesis P : path_at.

Lemma path_uniq : uniq path_darts.
Proof.
case/and5P: P => /eqP s1 /eqP s2 /eqP s3 /eqP s4 /andP[/eqP s5 /eqP s6].
have /eqP a1 := alpha_neq x; have /eqP a2 := alpha_neq (sigma x).
have [a3 a4] := (alphaK (sigma x), alphaK x); have a5 := alphaK (sigma (alpha (sigma x))).
by rewrite /path_darts /= !inE !negb_or; do ! (apply/andP; split) => //; apply/eqP => E; congruence.
Qed.

Lemma path_step u : u \in path_darts -> (sigma u \in path_darts) && (alpha u \in path_darts).
Proof.
case/and5P: P => _ /eqP s2 /eqP s3 _ /andP[/eqP s5 /eqP s6]; rewrite /path_darts !inE.
by do ! case/orP; move/eqP->; rewrite ?s2 ?s3 ?s5 ?s6 ?alphaK ?eqxx ?orbT.
Qed.

Lemma path_all u : u \in path_darts.
Proof.
by apply: (everywhere (A := fun u => u \in path_darts)) (mem_head _ _) _ _ _ => v /path_step/andP[].
Qed.
End Path.

Lemma paths_isomorphic (G H : combinatorial_map) (x : G) (y : H) : path_at x -> path_at y ->
  isomorphic (rooted x) (rooted y) /\ isomorphic (rooted (sigma x)) (rooted (sigma y)).
Proof.
move=> P Q; have [U V] := (path_uniq P, path_uniq Q); pose l := zip (path_darts x) (path_darts y).
have C : all (fun p => ((sigma p.1, sigma p.2) \in l) && ((alpha p.1, alpha p.2) \in l)) l.
  case/and5P: P Q => _ /eqP s2 /eqP s3 _ /andP[/eqP s5 /eqP s6].
  case/and5P=> _ /eqP s2' /eqP s3' _ /andP[/eqP s5' /eqP s6'].
  by rewrite /l /path_darts /= !inE s2 s3 s5 s6 s2' s3' s5' s6' !alphaK !eqxx ?orbT.
by split; apply: (@listed_isomorphic _ _ _ _ l); rewrite ?inE ?eqxx ?orbT.
Qed.

(* ---- Three reasons ---- *)
Section Reasons.
Variable c : nat -> nat.
Local Notation away := (c 0).
Local Notation neighbour := (c 1).
Local Notation behind := (c 2).
Local Notation door := (c 3).
Local Notation next := (c 4).
Local Notation other := (c 5).

Definition reason_behind := behind \notin [:: away; neighbour; door; next; other].
Definition reason_edge :=
  (door \notin [:: away; neighbour; behind]) && (behind \notin [:: neighbour; next; other]).
Definition merged := [::
  (door == next) && (next == other); (door == behind) && (behind == other);
  (door == behind) && (next == other); (door == behind) && (next == neighbour);
  (door == other) && (next == behind); (door == neighbour) && (next == behind);
  (door == next) && (behind == neighbour); (door == away) && (behind == neighbour);
  [&& door == next, next == behind & behind == away];
  [&& door == next, next == neighbour & other == behind]].
Definition reason_apart := ~~ has id merged.

Section Alike.
Variables W W' : lighthouse_world.
Local Notation alike := (indistinct (percept_by (coarsened c) (W := W)) (percept_by (coarsened c) (W := W'))).

Lemma alike_letter x y : alike x y -> c (feature pointed x) = c (feature pointed y).
Proof. by case/indistinct_senses. Qed.

Lemma alike_fixed x y : alike x y -> (sigma x == x) = (sigma y == y).
Proof. by rewrite !fixed_degree => /indistinct_senses[->]. Qed.

Lemma alike_twice x y : alike x y -> sigma (sigma x) = x -> sigma (sigma y) = y.
Proof. by case/indistinct_senses=> D _; exact: twice_degree. Qed.
End Alike.

Section World.
Variable W : lighthouse_world.
Local Notation r := (@pointed W).
Local Notation b := (alpha r).
Local Notation s := (sigma r).
Local Notation senses := (percept_by (coarsened c) (W := W)).
Local Notation alike := (indistinct senses senses).
Local Notation at_v0 x := (at_same_vertex x r).
Local Notation f := (feature r).

Lemma f_door : f r = 3. Proof. by rewrite /feature eqxx. Qed.

Lemma f_behind : f b = 2. Proof. by rewrite /feature eqxx ifN ?alpha_neq. Qed.

Lemma f_next : s <> r -> s <> b -> f s = 4.
Proof. by rewrite /feature vertex_sigma eqxx vertex_refl => /eqP/negPf-> /eqP/negPf->. Qed.

Lemma behind_rigid : reason_behind -> rigid (coarsened c) W.
Proof.
rewrite /reason_behind !inE !negb_or => /and5P[/eqP ? /eqP ? /eqP ? /eqP ? /eqP ?].
apply: (@alone_rigid _ _ _ b) => y /alike_letter; rewrite f_behind.
by case: (featureP r y) => *; congruence.
Qed.

Lemma edge_rigid : reason_edge -> rigid (coarsened c) W.
Proof.
rewrite /reason_edge !inE !negb_or => /andP[/and3P[/eqP ? /eqP ? /eqP ?] /and3P[/eqP ? /eqP ? /eqP ?]].
apply: (@alone_rigid _ _ _ r) => y A; apply/eqP; case: eqP => // ny; exfalso.
have nb : alpha y <> b by move/alpha_inj.
have vy : at_v0 y by move: (alike_letter A); rewrite f_door; case: (featureP r y) => * //; congruence.
move: (alike_letter (indistinct_alpha A)) (near_alpha vy); rewrite f_behind.
by case: (featureP r (alpha y)) => [*|*|*|*|*|_ _ /negP n _ /n //]; congruence.
Qed.

Hypothesis ok : reason_apart.

Lemma merged_no i : nth false merged i -> False.
Proof.
move=> m; case/hasP: ok; exists true => //; rewrite -m mem_nth // ltnNge.
by apply/negP=> le; rewrite nth_default in m.
Qed.

Ltac apply_merged i :=
  solve [apply: (@merged_no i); rewrite /=; repeat (apply/andP; split); apply/eqP; congruence].
Ltac clash := exfalso; first [congruence
  | match goal with H : is_true (~~ at_same_vertex _ _), K : is_true (at_same_vertex _ _) |- _ =>
      solve [move/negP: H; move: K; rewrite ?vertex_sigma => K; case; exact: K] end
  | match goal with H : is_true (~~ near _ _), K : is_true (near _ _) |- _ =>
      solve [move/negP: H; move: K; rewrite ?near_sigma => K; case; exact: K] end
  | apply_merged 0 | apply_merged 1 | apply_merged 2 | apply_merged 3 | apply_merged 4
  | apply_merged 5 | apply_merged 6 | apply_merged 7 | apply_merged 8 | apply_merged 9].
Ltac kinds x := case: (featureP r x) => [?|?|? ? ? ?|? ? ? ?|? ? ?|? ? ?].

(* v0 has three darts or more *)
Lemma next_alone : s <> r -> sigma s <> r -> s <> b -> alike r s -> False.
Proof.
move=> sr ssr sb B; have ss : sigma s <> s by move/sigma_inj.
have vs : at_v0 s by rewrite vertex_sigma vertex_refl.
have nas := near_alpha vs; have /eqP aas := alpha_neq s.
have asb : alpha s <> b by move/alpha_inj.
have as_r : alpha s <> r by move=> E; apply: sb; rewrite -[LHS]alphaK E.
move: (alike_letter B) (alike_letter (indistinct_sigma B)) (alike_letter (indistinct_alpha B)).
rewrite f_door f_behind f_next // => ?; kinds (alpha s); kinds (sigma s) => ? ?; clash.
Qed.

Lemma big_rigid : s <> r -> sigma s <> r -> rigid (coarsened c) W.
Proof.
move=> sr ssr; apply: (@alone_rigid _ _ _ r) => y A; apply/eqP; case: eqP => // ny; exfalso.
have nt : sigma y <> s by move/sigma_inj.
have sy : sigma y <> y by move: (alike_fixed A) => /= E /eqP; rewrite -E => /eqP.
have /eqP br : b != r by rewrite alpha_neq.
have vs : at_v0 s by rewrite vertex_sigma vertex_refl.
have vss : at_v0 (sigma s) by rewrite vertex_sigma.
have nb : near r b by rewrite near_alpha ?vertex_refl.
have ss : sigma s <> s by move/sigma_inj.
have E1 := alike_letter A; have E2 := alike_letter (indistinct_sigma A).
have E3 := alike_letter (indistinct_sigma (indistinct_sigma A)); rewrite f_door in E1.
have S : f s = if s == b then 2 else 4.
  by case: eqP => [->|sb]; [exact: f_behind | exact: f_next].
rewrite S in E2; case: (boolP (at_v0 y)) => vy.
  have {E3} Bs : alike r s -> s <> b -> False by move=> B sb; exact: next_alone.
  move: E1; kinds y => E1; try by clash.
  - subst y; move: E2; case: (s =P b) => [sb|sb]; kinds (sigma b) => E2; try by clash.
    by apply: Bs sb; rewrite indistinct_sym; have := indistinct_sigma A; congr indistinct.
  - by subst y; exact: Bs.
  by move: E2; case: (s =P b) => sb; kinds (sigma y) => E2; clash.
have vt : ~~ at_v0 (sigma y) by rewrite vertex_sigma.
have vtt : ~~ at_v0 (sigma (sigma y)) by rewrite vertex_sigma.
have tr : sigma y <> r by move=> E; rewrite E vertex_refl in vt.
have ttr : sigma (sigma y) <> r by move=> E; rewrite E vertex_refl in vtt.
have tts : sigma (sigma y) <> s by move/sigma_inj.
have tss : sigma (sigma y) <> sigma s by move=> /sigma_inj /sigma_inj.
move: E1; kinds y => E1; try by clash.
- subst y; move: E2; case: (s =P b) => sb; first by rewrite sb (negPf vy) in vs.
  by kinds (sigma b) => E2; clash.
- move: E2 E3; case: (s =P b) => sb; first rewrite -sb in nb *.
    by kinds (sigma y) => E2; try solve [clash]; kinds (sigma s); kinds (sigma (sigma y)) => E3; clash.
  by kinds (sigma y) => E2; try solve [clash]; kinds (sigma s); kinds (sigma (sigma y)) => E3; clash.
have tb : sigma y <> b by move=> E; move: nb; rewrite -E near_sigma; exact/negP.
have ttb : sigma (sigma y) <> b by move=> E; move: nb; rewrite -E !near_sigma; exact/negP.
by move: E2 E3; case: (s =P b) => sb; kinds (sigma y) => E2; try solve [clash];
  kinds (sigma s); kinds (sigma (sigma y)) => E3; clash.
Qed.

Lemma off_v0 x : ~~ at_v0 x -> x <> r /\ x <> s.
Proof. by move=> v; split=> E; move: v; rewrite E ?vertex_sigma vertex_refl. Qed.

(* v0 has two darts *)
Section Two.
Hypotheses (sr : s <> r) (ssr : sigma s = r) (sb : s <> b).

Lemma two_at_v0 x : at_v0 x -> x = r \/ x = s.
Proof. by rewrite at_same_vertex_sym; exact: of_two. Qed.

Lemma two_next_behind : sigma b <> b -> ~~ at_v0 (sigma b) /\ near r (sigma b).
Proof.
have nb : near r b by rewrite near_alpha ?vertex_refl.
rewrite vertex_sigma near_sigma => _; split=> //; apply/negP=> /two_at_v0[] //.
  by move=> E; have := alpha_neq r; rewrite E eqxx.
by move=> E; apply: sb.
Qed.

Lemma two_rigid : door <> next -> rigid (coarsened c) W.
Proof.
move=> DN; apply: (@alone_rigid _ _ _ r) => y A; apply/eqP; case: eqP => // ny; exfalso.
have sy : sigma y <> y by move: (alike_fixed A) => /= E /eqP; rewrite -E => /eqP.
have nb : near r b by rewrite near_alpha ?vertex_refl.
have vb : ~~ at_v0 b by apply/negP=> /two_at_v0[/eqP|E]; [rewrite (negPf (alpha_neq r)) | exact: sb].
move: (alike_letter A) (alike_letter (indistinct_sigma A)); rewrite f_door f_next //.
case: (boolP (at_v0 y)) => vy.
  by case: (two_at_v0 vy) => // ->; rewrite f_next.
have vt : ~~ at_v0 (sigma y) by rewrite vertex_sigma.
have tr : sigma y <> r by move=> E; rewrite E vertex_refl in vt.
have yb : y = b -> near r (sigma y) by move=> ->; rewrite near_sigma.
have tb : sigma y = b -> near r y by move=> E; rewrite -near_sigma E.
by kinds y; kinds (sigma y) => E1 E2; first [clash
  | match goal with H : is_true (~~ near _ _) |- _ => by case/negP: H; auto end].
Qed.

Lemma two_next_rigid : door = next ->
  behind <> away /\ behind <> door \/ door <> away /\ door <> neighbour -> rigid (coarsened c) W.
Proof.
move=> DN; have BN : behind <> neighbour by move=> ?; clash.
have no_other x : at_v0 x -> x <> r -> x <> s -> False by move=> /two_at_v0[].
case=> [[BA BD]|[DA Dn]].
  apply: (@alone_rigid _ _ _ b) => y /alike_letter; rewrite f_behind.
  by kinds y => // *; first [congruence | case: (no_other y)].
apply: (@alone_rigid _ _ _ r) => y A; apply/eqP; case: eqP => // ny; exfalso.
have sy : sigma y <> y by move: (alike_fixed A) => /= E /eqP; rewrite -E => /eqP.
move: (alike_letter A); rewrite f_door; kinds y; try congruence; move=> _; last by apply: (no_other y).
  subst y; have [vb nb] := two_next_behind sy; have [? ?] := off_v0 vb.
  by move: (alike_letter (indistinct_sigma A)); rewrite f_next //; kinds (sigma b) => E; clash.
subst y; have vs : at_v0 s by rewrite vertex_sigma vertex_refl.
have as_r : alpha s <> r by move=> E; apply: sb; rewrite -[LHS]alphaK E.
have /eqP as_s := alpha_neq s.
move: (alike_letter (indistinct_alpha A)) (near_alpha vs) (no_other (alpha s)); rewrite f_behind.
have as_b : alpha s <> b by move/alpha_inj.
by kinds (alpha s) => *; first [clash | case: (no_other (alpha s))].
Qed.

(* the path: v0 has degree 2, and what is beyond its other edge looks as v0 does *)
Lemma path_or_rigid : door = next -> behind = away -> door = neighbour -> behind <> door ->
  rigid (coarsened c) W \/ path_at r /\ alike r (sigma (alpha s)).
Proof.
move=> DN BA Dn BD; have no_other x : at_v0 x -> x <> r -> x <> s -> False by move=> /two_at_v0[].
have [all|] := boolP [forall y, alike b y ==> (y == b)].
  by left; apply: (@alone_rigid _ _ _ b) => y; move/forallP/(_ y)/implyP: all => H /H /eqP.
case/forallPn=> y; rewrite negb_imply => /andP[A /eqP nyb]; right.
have vs : at_v0 s by rewrite vertex_sigma vertex_refl.
have nas := near_alpha vs.
have B := indistinct_alpha A; rewrite alphaK in B; set z := alpha y in B *.
have [vy ny] : ~~ at_v0 y /\ ~~ near r y.
  move: (alike_letter A); rewrite f_behind.
  by kinds y => // *; first [congruence | case: (no_other y)].
have [vz nz] : ~~ at_v0 z /\ near r z.
  have zr : z <> r by move=> E; apply: nyb; rewrite -[y]alphaK -/z E.
  have zs : z <> s by move=> E; move: ny; rewrite -[y]alphaK -/z E nas.
  move: (alike_letter B); rewrite f_door.
  by kinds z => // *; first [congruence | case: (no_other z)].
have C := indistinct_sigma B; set t := sigma z in C.
have ssz : sigma t = z by apply: twice_degree ssr; case/indistinct_senses: B.
have tb : t <> b by move=> E; move: (alike_letter C); rewrite f_next // E f_behind; congruence.
have ats : alpha t = s.
  case/existsP: nz => w /andP[zw]; case/(of_two ssz): zw => ->.
    by rewrite alphaK (negPf vy).
  case/two_at_v0 => // E; case: tb; by rewrite -[LHS]alphaK E.
have ast : alpha s = t by rewrite -ats alphaK.
have sbb : sigma b = b.
  apply/eqP; case: eqP => // nbb; have [vbb nbb'] := two_next_behind nbb; have [? ?] := off_v0 vbb.
  have yb : sigma y <> b by move=> E; move: (near_alpha (vertex_refl r)); rewrite -E near_sigma; exact/negP.
  have [vsy nsy] : ~~ at_v0 (sigma y) /\ ~~ near r (sigma y) by rewrite vertex_sigma near_sigma.
  have [? ?] := off_v0 vsy.
  by move: (alike_letter (indistinct_sigma A)); kinds (sigma b); kinds (sigma y) => *; clash.
have syy : sigma y = y by apply/eqP; rewrite -(alike_fixed A) sbb.
have zy : alpha z = y by rewrite /z alphaK.
rewrite /path_at /= ast ssz ssr sbb zy syy !eqxx /= andbT.
have := alike_fixed B; rewrite (negPf (introN eqP sr)) => /esym; rewrite eq_sym => ->.
by split=> //; exact/eqP.
Qed.
End Two.

(* v0 has one dart *)
Lemma leaf_rigid : s = r -> sigma b <> b -> rigid (coarsened c) W.
Proof.
move=> sr sbb; have only x : at_v0 x -> x = r by rewrite at_same_vertex_sym => /of_two[]; rewrite ?sr.
have br : b <> r by apply/eqP; rewrite alpha_neq.
have nb : near r b by rewrite near_alpha ?vertex_refl.
have vb : ~~ at_v0 b by apply/negP=> /only.
have [vt nt] : ~~ at_v0 (sigma b) /\ near r (sigma b) by rewrite vertex_sigma near_sigma.
have [? ?] := off_v0 vt.
have [E|BN] := behind =P neighbour.
  apply: (@alone_rigid _ _ _ r) => y A; apply/eqP; case: eqP => // ny; exfalso.
  have sy : sigma y = y by apply/eqP; rewrite -(alike_fixed A) sr.
  move: (alike_letter A); rewrite f_door; kinds y => *; try clash.
    by case: ny; exact: only.
  have /existsP[w /andP[yw /only aw]] : near r y by [].
  have wb : w = b by rewrite -aw alphaK.
  have : w = y by case: (of_two (x := y) _ yw); rewrite ?sy.
  by congruence.
apply: (@alone_rigid _ _ _ b) => y A; apply/eqP; case: eqP => // ny; exfalso.
have sy : sigma y <> y by move: (alike_fixed A) => /= E /eqP; rewrite -E => /eqP.
move: (alike_letter A) (alike_letter (indistinct_sigma A)); rewrite f_behind; kinds y => E; try clash.
  by case: sy; rewrite (only y) ?sr.
have [vsy nsy] : ~~ at_v0 (sigma y) /\ ~~ near r (sigma y) by rewrite vertex_sigma near_sigma.
have [? ?] := off_v0 vsy.
have yb : sigma y <> b by move=> F; move: nsy; rewrite F nb.
by kinds (sigma b); kinds (sigma y) => *; clash.
Qed.

Theorem rigid_or : [\/ rigid (coarsened c) W, s = r /\ sigma b = b, s = b /\ sigma b = r |
  [/\ path_at r, alike r (sigma (alpha s)), door = next & behind <> door]].
Proof.
have [sr|sr] := s =P r.
  have [sbb|sbb] := sigma b =P b; first by apply: Or42.
  by apply: Or41; exact: leaf_rigid.
have [ssr|ssr] := sigma s =P r; last by apply: Or41; exact: big_rigid.
have [sb|sb] := s =P b; first by apply: Or43; rewrite -sb.
have [DN|DN] := door =P next; last by apply: Or41; exact: two_rigid.
have BN : behind <> neighbour by move=> ?; clash.
have [BD|BD] := behind =P door.
  by apply: Or41; apply: two_next_rigid => //; right; split=> ?; clash.
have [BA|BA] := behind =P away; last by apply: Or41; apply: two_next_rigid => //; left.
have [Dn|Dn] := door =P neighbour.
  by case: (path_or_rigid sr ssr sb DN BA Dn BD) => [|[? ?]]; [exact: Or41 | exact: Or44].
by apply: Or41; apply: two_next_rigid => //; right; split=> // ?; clash.
Qed.

End World.
End Reasons.
