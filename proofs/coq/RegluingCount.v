(* ---------------------------------------------------------------------------------------------
   How many worlds look like a given one: the criterion, counted.                       Section III

   Position only.  The worlds that look alike are the regluings of one (Regluing.v).  Two regluings are the
   same, place included, if a bijection that turns with the darts, keeps what they look like and fixes the
   start takes the one to the other; no two of these bijections do that.  So the regluings fall into parts
   of equal size.

     regluing b           b may stand for alpha: reglued_by b is the world with it.
     turning f            f is such a bijection.
     same_regluing b c    some turning takes b to c;  lookalike_worlds: the parts.
     count_regluings      as many regluings as parts times turnings.
     same_regluing_isomorphic   a part is one of the worlds that look alike, place included.
     map_known_iff        the map, with v0 in it, can be known if and only if there are as many regluings as
                          places (Ambiguity.v) times turnings.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Indistinguishable PositionTwins Ambiguity.
From Allworlds Require Import Regluing.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Count.
Variables (G : combinatorial_map) (d : G).
Local Notation indistinct := (indistinct (position_of d) (position_of d)).
Local Notation dart_function := {ffun G -> G}.
Implicit Types (b c f g : dart_function) (x y : G).

Definition regluing b := [&& [forall x, b (b x) == x], [forall x, b x != x]
  & [forall x, indistinct (alpha x) (b x)]].
Definition turning f := [&& injectiveb f, [forall x, f (sigma x) == sigma (f x)],
  [forall x, indistinct x (f x)] & f d == d].

Lemma regluingP b : reflect [/\ involutive b, forall x, b x != x & forall x, indistinct (alpha x) (b x)]
  (regluing b).
Proof.
apply: (iffP and3P) => [[/forallP K /forallP N /forallP A]|[K N A]]; split=> //.
- by move=> x; exact/eqP.
- by apply/forallP=> x; rewrite K.
- exact/forallP.
exact/forallP.
Qed.

Lemma turningP f : reflect [/\ injective f, forall x, f (sigma x) = sigma (f x),
  forall x, indistinct x (f x) & f d = d] (turning f).
Proof.
apply: (iffP and4P) => [[/injectiveP i /forallP s /forallP k /eqP e]|[i s k e]]; split=> //.
- by move=> x; exact/eqP.
- exact/injectiveP.
- by apply/forallP=> x; rewrite s.
- exact/forallP.
exact/eqP.
Qed.

Definition takes f b c := [forall x, f (b x) == c (f x)].
Definition same_regluing b c := [exists f, turning f && takes f b c].
Definition regluings := [set b | regluing b].
Definition lookalike_worlds := equivalence_partition same_regluing regluings.

Lemma same_regluingP b c : reflect (exists2 f, turning f & forall x, f (b x) = c (f x)) (same_regluing b c).
Proof.
apply: (iffP existsP) => [[f /andP[t /forallP k]]|[f t k]]; exists f => //; first by move=> x; exact/eqP.
by rewrite t; apply/forallP=> x; rewrite k.
Qed.

Lemma same_regluing_refl b : same_regluing b b.
Proof.
apply/same_regluingP; exists [ffun x => x]; last by move=> x; rewrite !ffunE.
by apply/turningP; split=> [x y|x|x|]; rewrite !ffunE //; exact: indistinct_refl.
Qed.

Lemma same_regluing_equivalence : {in regluings & &, equivalence_rel same_regluing}.
Proof.
have sym b c : same_regluing b c -> same_regluing c b.
  case/same_regluingP=> f /turningP[i s k e] fb; apply/same_regluingP; exists [ffun x => finv f x].
    apply/turningP; split=> [x y|x|x|]; rewrite ?ffunE.
    - by move/(congr1 f); rewrite !(f_finv i).
    - by apply: (i); rewrite s !(f_finv i).
    - by rewrite indistinct_sym -{2}(f_finv i x); exact: k.
    by rewrite -{1}e (finv_f i).
  by move=> x; rewrite !ffunE; apply: (i); rewrite fb !(f_finv i).
have trans b c c' : same_regluing b c -> same_regluing c c' -> same_regluing b c'.
  case/same_regluingP=> f /turningP[i s k e] fb /same_regluingP[g /turningP[i' s' k' e'] gc].
  apply/same_regluingP; exists [ffun x => g (f x)]; last by move=> x; rewrite !ffunE fb gc.
  apply/turningP; split=> [x y|x|x|]; rewrite !ffunE ?e ?s ?s' //; first by move/i'/i.
  exact: indistinct_trans (k x) (k' _).
move=> b c c' _ _ _; split=> [|bc]; first exact: same_regluing_refl.
apply/idP/idP; last exact: trans.
exact: trans (sym _ _ bc).
Qed.

(* the world with b for alpha *)
Section World.
Variable b : dart_function.
Hypothesis rb : regluing b.

Lemma regluingK : involutive b. Proof. by have /regluingP[] := rb. Qed.
Lemma regluing_neq x : b x != x. Proof. by have /regluingP[] := rb. Qed.
Lemma regluing_near x : indistinct (alpha x) (b x). Proof. by have /regluingP[] := rb. Qed.

Definition reglued_by := reglued regluingK regluing_neq regluing_near.
End World.

(* two turnings that take b to the same are one *)
Lemma turning_determined b c f g : regluing b -> turning f -> turning g ->
  (forall x, f (b x) = c (f x)) -> (forall x, g (b x) = c (g x)) -> f = g.
Proof.
move=> rb /turningP[_ sf _ ef] /turningP[_ sg _ eg] fb gb; apply/ffunP.
by apply: (@morphisms_agree (reglued_by rb) G sigma c f g d) => //; rewrite ef eg.
Qed.

Theorem count_regluings : #|regluings| = #|lookalike_worlds| * #|[set f | turning f]|.
Proof.
apply: card_uniform_partition (equivalence_partitionP same_regluing_equivalence) => A /imsetP[b].
rewrite inE => rb ->; pose conj f := [ffun x => f (b (finv f x))] : dart_function.
have conjP f : turning f -> forall x, f (b x) = conj f (f x).
  by case/turningP=> i _ _ _ x; rewrite ffunE (finv_f i).
have conj_regluing f : turning f -> regluing (conj f).
  move=> t; have /turningP[i s k e] := t; have /regluingP[K N near] := rb.
  apply/regluingP; split=> x; rewrite !ffunE ?(finv_f i) ?K ?(f_finv i) //.
    by apply/eqP=> /(congr1 (finv f)); rewrite (finv_f i) => /eqP; rewrite (negbTE (N _)).
  apply: indistinct_trans (k _); apply: indistinct_trans (near _); apply: indistinct_alpha.
  by rewrite indistinct_sym -{2}(f_finv i x); exact: k.
rewrite -[RHS](card_in_imset (f := conj)); last first.
  move=> f g; rewrite !inE => tf tg E; apply: (@turning_determined b (conj f) f g rb tf tg).
    exact: conjP.
  by move=> x; rewrite E conjP.
apply: eq_card => c; rewrite !inE; apply/andP/imsetP=> [[rc /same_regluingP[f tf k]]|[f]].
  exists f; first by rewrite inE.
  by have /turningP[i _ _ _] := tf; apply/ffunP=> x; rewrite ffunE k (f_finv i).
rewrite inE => tf ->; split; first exact: conj_regluing.
by apply/same_regluingP; exists f => //; exact: conjP.
Qed.

(* ---- The parts are the worlds that look alike ---- *)
Lemma same_regluing_isomorphic b c (rb : regluing b) (rc : regluing c) : same_regluing b c <->
  isomorphic (rooted (d : reglued_by rb)) (rooted (d : reglued_by rc)).
Proof.
split=> [/same_regluingP[f /turningP[i s k e] fb]|[f [g [F F' r]]]].
  exists f, (finv f); split=> [x _|x _|] //=; last by rewrite (f_finv i).
  by split=> //; rewrite (finv_f i).
have fi : injective f by move=> x y E; have [_ <- _ _] := F x isT; rewrite E; have [] := F y isT.
have fs x : f (sigma x) = sigma (f x : G) by have [] := F x isT.
have fb x : f (b x) = c (f x) by have [] := F x isT.
apply/same_regluingP; exists (finfun f) => [|x]; last by rewrite !ffunE.
apply/turningP; split=> [x y|x|x|]; rewrite !ffunE //; first exact: fi.
have /(indistinct_alikeP _ _ d (d : reglued_by rb))[_ _ Eb] :=
  reglued_same (regluingK rb) (regluing_neq rb) (regluing_near rb) x.
have /(indistinct_alikeP _ _ d (d : reglued_by rc))[_ _ Ec] :=
  reglued_same (regluingK rc) (regluing_neq rc) (regluing_near rc) (f x).
apply/(indistinctP _ d) => w; rewrite Eb Ec.
suff [_ _ H] : alike (M := rooted (d : reglued_by rb)) (N := rooted (d : reglued_by rc))
    (position_of (d : reglued_by rb)) (position_of (d : reglued_by rc)) x (f x) by exact: H.
apply: (@bisimulation_alike _ (rooted (d : reglued_by rb)) (rooted (d : reglued_by rc)) _ _
  (fun u v : G => f u = v)) => // [u _ <-|u _ <-|u _ <-]; [|exact: fs|exact: fb].
split=> //; rewrite -[LHS]/(position_of d u) -[RHS]/(position_of d (f u)).
rewrite (@position_kept G d f d fi fs) //; first exact: connect0.
by rewrite [f d]r; exact: connect0.
Qed.

(* b, seen from the start, is the world itself seen from y *)
Definition shows b y := [exists f : dart_function, [&& injectiveb f, [forall x, f (sigma x) == sigma (f x)],
  [forall x, f (b x) == alpha (f x)] & f d == y]].

Lemma showsP b (rb : regluing b) y : reflect (isomorphic (rooted (d : reglued_by rb)) (rooted y)) (shows b y).
Proof.
apply: (iffP existsP) => [[f /and4P[/injectiveP i /forallP s /forallP a /eqP e]]|[f [g [F F' r]]]].
  exists f, (finv f); split=> [x _|x _|] //=; last by rewrite (f_finv i).
  by split=> //; [rewrite (finv_f i) | exact/eqP | exact/eqP].
exists (finfun f); apply/and4P; split.
- by apply/injectiveP=> x y' E; have [_ <- _ _] := F x isT; rewrite !ffunE in E; rewrite E; have [] := F y' isT.
- by apply/forallP=> x; rewrite !ffunE; have [_ _ -> _] := F x isT.
- by apply/forallP=> x; rewrite !ffunE; have [_ _ _ ->] := F x isT.
by rewrite ffunE; apply/eqP.
Qed.

Lemma look_alike_here y : y \in class (position_of d) d -> look_alike d y.
Proof.
rewrite inE => dy w; have c := lookalikes_at_v0 dy; have /(indistinctP _ d) -> := dy.
have same x : position_of d x = position_of y x.
  by rewrite /position_of /at_same_vertex (same_connect (fconnect_sym sigma_inj) c).
suff walk z : percepts_in (M := rooted d) (position_of d) w z
    = percepts_in (M := rooted y) (position_of y) w z by exact: walk.
by elim: w z => [|k w IH] z /=; rewrite same // IH.
Qed.

(* every place shows in a regluing, every regluing in a place at most *)
Lemma place_shown y : y \in class (position_of d) d -> exists2 b, regluing b & shows b y.
Proof.
move=> ky; have [beta [K [N [near I]]]] := alike_reglued (look_alike_here ky).
have rb : regluing (finfun beta) by apply/regluingP; split=> x; rewrite !ffunE.
exists (finfun beta) => //; apply/(showsP rb).
have [f [g [F F' r]]] := I; exists f, g; split=> // x _; have [? ? ? ?] := F x isT.
by split=> //=; rewrite ffunE.
Qed.

Lemma shown_place b y : regluing b -> at_same_vertex d y -> shows b y -> y \in class (position_of d) d.
Proof.
move=> rb c /existsP[f /and4P[/injectiveP i /forallP s /forallP a /eqP e]].
have fs x : f (sigma x) = sigma (f x) by exact/eqP.
have fa x : f (b x) = alpha (f x) by exact/eqP.
rewrite inE; apply/(indistinctP _ d) => w.
have -> : percepts_in (M := rooted d) (position_of d) w d
    = percepts_in (M := rooted (d : reglued_by rb)) (position_of (d : reglued_by rb)) w d.
  exact: reglued_alike.
suff [_ _ H] : alike (M := rooted (d : reglued_by rb)) (N := rooted d)
    (position_of (d : reglued_by rb)) (position_of d) d y by exact: H.
apply: (@bisimulation_alike _ (rooted (d : reglued_by rb)) (rooted d) _ _ (fun u v : G => f u = v)) =>
  // [u _ <-|u _ <-|u _ <-]; [|exact: fs|exact: fa].
split=> //; rewrite -[LHS]/(position_of d u).
by rewrite (@position_kept G d f d i fs) // ?e //; exact: connect0.
Qed.

Definition place_of y := [set z in class (position_of d) d | automorphic y z].
Definition part_of b := [set c in regluings | same_regluing b c].
Definition shown (A : {set G}) := [set b in regluings | [exists y in A, shows b y]].

Lemma shown_part b y : regluing b -> y \in class (position_of d) d -> shows b y ->
  shown (place_of y) = part_of b.
Proof.
move=> rb ky bs; have I := showsP rb y bs; have W := rooted_wellformed (d : reglued_by rb).
apply/setP=> c; rewrite !inE; case rc: (regluing c) => //=.
apply/existsP/idP=> [[z /andP[]]|bc].
  rewrite !inE => /andP[_ /(automorphic_isomorphic d) yz] /(showsP rc) cz.
  apply/(same_regluing_isomorphic rb rc).
  exact: (isomorphic_trans (isomorphic_trans I yz) (isomorphic_sym (rooted_wellformed _) cz)).
exists y; rewrite inE ky automorphic_refl /=; apply/(showsP rc).
have /(same_regluing_isomorphic rb rc) J := bc.
exact: (isomorphic_trans (isomorphic_sym (rooted_wellformed _) J) I).
Qed.

Lemma turnings_gt0 : 0 < #|[set f | turning f]|.
Proof.
apply/card_gt0P; exists [ffun x => x]; rewrite inE.
by apply/turningP; split=> [x y|x|x|]; rewrite !ffunE //; exact: indistinct_refl.
Qed.

Theorem map_known_iff :
  (forall (H : combinatorial_map) (e : H), look_alike d e ->
     exists2 y : G, at_same_vertex d y & isomorphic (rooted y) (rooted e)) <->
  #|regluings| = #|places d| * #|[set f | turning f]|.
Proof.
have placeE P : P \in places d -> exists2 y, y \in class (position_of d) d & P = place_of y.
  by case/imsetP=> y ky ->; exists y.
have in_places y : y \in class (position_of d) d -> place_of y \in places d.
  by move=> ky; apply/imsetP; exists y.
have in_parts b : regluing b -> part_of b \in lookalike_worlds.
  by move=> rb; apply/imsetP; exists b => //; rewrite inE.
have sub : shown @: places d \subset lookalike_worlds.
  apply/subsetP=> D /imsetP[P /placeE[y ky ->] ->]; have [b rb bs] := place_shown ky.
  by rewrite (shown_part rb ky bs) in_parts.
have inj : {in places d &, injective shown}.
  move=> P P' /placeE[y ky ->] /placeE[y' ky' ->] E; have [b rb bs] := place_shown ky.
  have : b \in shown (place_of y') by rewrite -E (shown_part rb ky bs) !inE rb same_regluing_refl.
  rewrite !inE => /andP[_ /existsP[z /andP[]]]; rewrite inE => /andP[_ y'z] /(showsP rb) I.
  have yz : automorphic y z.
    apply/(automorphic_isomorphic d); apply: isomorphic_trans I.
    by apply: isomorphic_sym (rooted_wellformed _) _; exact/(showsP rb).
  have yy' : automorphic y y' := automorphic_trans d yz (automorphic_sym d y'z).
  apply/setP=> u; rewrite !inE; congr (_ && _); apply/idP/idP; apply: (automorphic_trans d) => //.
  exact: (automorphic_sym d).
have count_places : #|shown @: places d| = #|places d| by exact: card_in_imset.
rewrite count_regluings; split=> [all|/eqP].
  congr (_ * _); apply/eqP; rewrite eqn_leq -count_places (subset_leq_card sub) andbT.
  apply/subset_leq_card/subsetP=> D /imsetP[b]; rewrite inE => rb ->.
  have [y c I] := all _ _ (reglued_alike (regluingK rb) (regluing_neq rb) (regluing_near rb)).
  have bs : shows b y by apply/(showsP rb); exact: isomorphic_sym (rooted_wellformed y) I.
  have ky := shown_place rb c bs; apply/imsetP; exists (place_of y); first exact: in_places.
  exact: esym (shown_part rb ky bs).
rewrite (eqn_pmul2r turnings_gt0) => /eqP E H e A.
have full : shown @: places d = lookalike_worlds.
  by apply/eqP; rewrite eqEcard sub count_places E leqnn.
have [beta [K [N [near I]]]] := alike_reglued A.
have rb : regluing (finfun beta) by apply/regluingP; split=> x; rewrite !ffunE.
have := in_parts _ rb; rewrite -full => /imsetP[P /placeE[y ky ->]] D.
have : finfun beta \in part_of (finfun beta) by rewrite !inE rb same_regluing_refl.
rewrite D !inE => /andP[_ /existsP[z /andP[]]]; rewrite inE => /andP[kz _] /(showsP rb) J.
exists z; first by apply: lookalikes_at_v0; rewrite inE in kz.
apply: isomorphic_trans (isomorphic_sym (rooted_wellformed _) J) _; apply: isomorphic_trans I.
by exists id, id; split=> // x _; split=> //=; rewrite ffunE.
Qed.
End Count.
