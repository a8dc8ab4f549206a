(* ---------------------------------------------------------------------------------------------
   Bouquets at a distance, explored with caution.                                       Section VI

   In the worlds of Bouquets.v a cautious explorer that crosses a loop from a known end, and does not know
   where it has come out, crosses one more edge at most, and unless that leads to v0 it goes straight back.

     whereabouts          Home: at v0.  Inside d: it has come in by d, and knows that.  Lost e o: it has come
                          out of the loop end e, it does not know where, and has turned by o from there.
                          Deep e o: it has left that vertex after the turn o, and was not at v0 then.
     loop_knowledge       the whereabouts, and of which loop end it is told that it is the other end.
     knows_after s j o    what is known after motion j and percept o.
     gets_to X a seen d s   explorer X in the world with the loops a, after these percepts: in the dart d, with
                          the knowledge s.
     cautious X           from Deep it goes back.
     really a p           the dart in which a robot is that is at p, if the loops are a.
     loops_are_closed     an explorer that finds the maps of all worlds has seen both ends of each loop.
     allows A a           the graph A has the pairs of a.
     paid A s             what the graph without some pairs, and the loops known, have cost: a pair less two
                          motions, a loop three.
     cautious_needs       c (2c+1) motions in one of the bouquets with c = k+1 loops.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import Lia.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers MassFormula PathWorlds.
From Allworlds Require Import Log OpenDarts TwoSheets.
From Bounds Require Import Gluings Bouquets Matchings Corridors.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Cautious.
Variable k : nat.
Local Notation c := k.+1.
Local Notation loop_end := 'I_(k.*2.+2).
Local Notation dart := (loop_end + bool)%type.
Local Notation at_v0 := (at_v0 k).
Local Notation worlds := (fun a : loop_matching k => rooted (@start (hanging a))).
Local Notation senses := (fun a : loop_matching k => @percept_of (hanging a)).
Implicit Types (a : loop_matching k) (x y : loop_end) (d : dart).

(* the darts of the vertex with the loops, and how many they are *)
Definition loop_ring := k.*2.+3.
Definition turned_by j d : dart := iter j (@sigma (hanging (nested k))) d.

Lemma turned_byE a j d : iter j (@sigma (hanging a)) d = turned_by j d.
Proof. by []. Qed.

Lemma turned_byD j j' d : turned_by j (turned_by j' d) = turned_by (j' + j) d.
Proof. by rewrite /turned_by addnC iterD. Qed.

Lemma turned_inj j : injective (turned_by j).
Proof. by elim: j => [|j IH] d d' //; rewrite /turned_by !iterS => /(@sigma_inj (hanging (nested k)))/IH. Qed.

Lemma turned_inside j d : d <> at_v0 -> turned_by j d <> at_v0.
Proof. by move=> n E; apply: n; apply: (@turned_inj j); rewrite E /turned_by turn_v0. Qed.

Lemma full_turn j d : d <> at_v0 -> j %% loop_ring = 0 -> turned_by j d = d.
Proof.
move=> n jr; have o : order (@sigma (hanging (nested k))) d = loop_ring.
  rewrite /order -(_ : #|predC1 at_v0| = loop_ring).
    apply: eq_card => x; rewrite !inE -[LHS]/(at_same_vertex (d : hanging (nested k)) x).
    case: eqP => [->|nx]; last by rewrite one_vertex.
    by rewrite old_vertexE; case: d n => [i|[]].
  by have := cardC1 at_v0; rewrite card_sum card_ord card_bool addn2 => ->.
have := divn_eq j loop_ring; rewrite jr addn0 => ->; elim: (_ %/ _) => // q IH.
by rewrite mulSn -turned_byD -{2}o /turned_by iter_order ?IH //; exact: (@sigma_inj (hanging (nested k))).
Qed.

(* ---- What is known ---- *)
Inductive whereabouts := Home | Inside of dart | Lost of loop_end & nat | Deep of loop_end & nat.
Record loop_knowledge := Know { whereabouts_of : whereabouts; end_told : loop_end -> option loop_end }.

Definition joined_ends e y (p : loop_end -> option loop_end) x :=
  if x == e then Some y else if x == y then Some e else p x.

Definition knows_after s j (o : percept) : loop_knowledge :=
  match whereabouts_of s with
  | Home => Know (Inside (inr true)) (end_told s)
  | Inside d =>
      match turned_by j d with
      | inr _ => Know Home (end_told s)
      | inl e => if end_told s e is Some y then Know (Inside (inl y)) (end_told s) else Know (Lost e 0) (end_told s)
      end
  | Lost e o' =>
      if (o' + j) %% loop_ring == 0 then Know (Inside (inl e)) (end_told s)
      else if o.2 is None then Know (Deep e (o' + j)) (end_told s)
      else if [pick y | turned_by (o' + j) (inl y) == inr true] is Some y
        then Know Home (joined_ends e y (end_told s))
      else s
  | Deep e o' => Know (Lost e o') (end_told s)
  end.

Section Explorer.
Variables (E : Type) (X : explorer percept E).

Inductive gets_to a : seq percept -> dart -> loop_knowledge -> Prop :=
| gets_to_first : gets_to a [:: senses a at_v0] at_v0 (Know Home (fun=> None))
| gets_to_next seen d s j : gets_to a seen d s -> X seen = Move j ->
    gets_to a (rcons seen (senses a (motion_in (worlds a) j d))) (motion_in (worlds a) j d)
      (knows_after s j (senses a (motion_in (worlds a) j d))).

Definition cautious := forall a seen d s e o j,
  gets_to a seen d s -> whereabouts_of s = Deep e o -> X seen = Move j -> j %% loop_ring = 0.

Definition really a p : dart :=
  match p with
  | Home => at_v0
  | Inside d => d
  | Lost e o => turned_by o (inl (val a e))
  | Deep e o => @alpha (hanging a) (turned_by o (inl (val a e)))
  end.

Definition lost_from p := match p with Lost e _ => Some e | Deep e _ => Some e | _ => None end.

Record true_of a d s : Prop := TrueOf {
  true_place : d = really a (whereabouts_of s);
  true_inside : whereabouts_of s <> Home -> d <> at_v0;
  true_partner : forall x y, end_told s x = Some y -> val a x = y;
  known_twice : forall x y, end_told s x = Some y -> end_told s y = Some x;
  lost_unknown : forall e, lost_from (whereabouts_of s) = Some e -> end_told s e = None }.

Lemma senses_v0 a : senses a at_v0 = home_percept (nested k).
Proof. exact: sensed_home. Qed.
Lemma senses_inside a d : d <> at_v0 -> senses a d = away_percept (nested k).
Proof. exact: sensed_away. Qed.
Lemma home_some : (home_percept (nested k)).2 <> None.
Proof. by rewrite /home_percept /percept_of bearing_v0. Qed.
Lemma away_none : (away_percept (nested k)).2 = None.
Proof. by rewrite /away_percept /percept_of no_bearing. Qed.

(* the next dart, from the one and the motion *)
Lemma motion_from a j d : motion_in (worlds a) j d = @alpha (hanging a) (turned_by j d).
Proof. by []. Qed.

Lemma not_inr d : d <> at_v0 -> d = inr true \/ exists x, d = inl x.
Proof. by case: d => [x|[]] // _; [right; exists x | left]. Qed.

(* at the end of a test: v0, if it comes out at the stem, else another loop end *)
Lemma test_hits a d : d = inr true -> @alpha (hanging a) d = at_v0.
Proof. by move=> ->. Qed.

Lemma test_misses a e o : turned_by o (inl (val a e)) <> inr true ->
  @alpha (hanging a) (turned_by o (inl (val a e))) <> at_v0.
Proof.
move=> h; have n : turned_by o (inl (val a e)) <> at_v0 by exact: turned_inside.
by case: (not_inr n) => [//|[x ->]].
Qed.

Lemma learns_true a d s j : true_of a d s -> (forall e o, whereabouts_of s = Deep e o -> j %% loop_ring = 0) ->
  true_of a (motion_in (worlds a) j d) (knows_after s j (senses a (motion_in (worlds a) j d))).
Proof.
case=> tp ti tq kt lu back; rewrite motion_from /knows_after.
case P: (whereabouts_of s) tp ti lu back => [|x|e o|e o] tp ti lu back.
- by rewrite tp /turned_by turn_v0; split.
- have n : d <> at_v0 by apply: ti.
  have /not_inr[t|[e t]] := turned_inside (j := j) n; rewrite tp in t; rewrite tp t; first by split.
  by case K: (end_told s e) => [y|]; split=> //=; rewrite ?(tq _ _ K) //; move=> e' [<-].
- have n : inl (val a e) <> at_v0 by [].
  rewrite tp turned_byD; case: eqP => [z|nz].
    by rewrite full_turn //; split=> //=; rewrite ?matched_back.
  case: (turned_by (o + j) (inl (val a e)) =P inr true) => [h|h]; last first.
    have m := test_misses h; rewrite senses_inside // away_none; split=> //= e' [<-]; exact: lu.
  rewrite (test_hits a h) senses_v0; case S: (home_percept _).2 => [b|]; last by have := home_some.
  case: pickP => [y /eqP ty|no]; last by have := no (val a e); rewrite h eqxx.
  have ey : y = val a e by have := @turned_inj (o + j) _ _ (etrans ty (esym h)); case.
  split=> //= x z; rewrite /joined_ends.
    by case: eqP => [->|_]; [case=> <- | case: eqP => [-> [<-]|_ /tq//]; rewrite ey matched_back].
  have ne : y != e by rewrite ey; exact: matched_apart.
  case: (x =P e) => [->|nx]; first by case=> <-; rewrite (negbTE ne) eqxx.
  case: (x =P y) => [-> [<-]|ny K]; first by rewrite eqxx.
  case: (z =P e) => [ze|_]; first by have := kt _ _ K; rewrite ze lu.
  case: (z =P y) => [zy|_]; last exact: kt.
  by case: nx; apply: (inv_inj (@matched_back _ a)); rewrite (tq _ _ K) zy ey.
- have j0 := back _ _ erefl; rewrite full_turn //; last by apply: ti.
  by rewrite tp alphaK; split=> //= _; exact: turned_inside.
Qed.

Hypothesis careful : cautious.

Lemma gets_to_true a seen d s : gets_to a seen d s -> true_of a d s.
Proof.
elim=> [|{}seen {}d {}s j S T Xj]; first by split.
by apply: learns_true T _ => e o P; exact: careful S P Xj.
Qed.

(* what is seen there belongs to an episode *)
Local Notation episode_in a := (episode X (worlds a) (senses a)).
Local Notation explore_in a := (explore X (worlds a) (senses a)).

Lemma gets_to_episode a seen d s : gets_to a seen d s -> exists t, size seen = (size t).+1 /\
  forall n t' r z, explore_in a n seen d = (t', r, z) -> episode_in a (size t + n) = (t ++ t', r, z).
Proof.
elim=> [|{}seen {}d {}s j S [t [sz R]] Xj]; first by exists [::].
exists (rcons t (j, senses a (motion_in (worlds a) j d))); rewrite !size_rcons sz; split=> // n t' r z R'.
by rewrite addSnnS cat_rcons; apply: R; rewrite /= Xj R'.
Qed.

Lemma gets_to_stops a seen d s e : gets_to a seen d s -> X seen = Stop e -> exists t,
  size seen = (size t).+1 /\ episode_in a (size t) = (t, Some e, d).
Proof.
move=> S Xe; have [t [sz R]] := gets_to_episode S; exists t; split=> //.
by rewrite -[in LHS](addn0 (size t)) -[in RHS](cats0 t); apply: R; rewrite /= Xe.
Qed.

Lemma gets_to_goes_on a seen d s j n t r z : gets_to a seen d s -> X seen = Move j ->
  episode_in a n = (t, Some r, z) -> size seen <= n.
Proof.
move=> S Xj Rn; have [t' [-> R]] := gets_to_episode S; rewrite ltnNge; apply/negP=> le.
have := R 0 [::] None d; rewrite /= Xj addn0 => /(_ erefl) R0.
have M : episode_in a (n + (size t' - n)) = (t, Some r, z) := explore_more _ Rn.
by rewrite subnKC // R0 in M.
Qed.

(* ---- A loop that is not closed ---- *)
Section OpenLoop.
Variables (a : loop_matching k) (e : loop_end).
Local Notation W := (hanging a).
Let on_loop (d : W) := (d == inl e) || (d == inl (val a e)).

Lemma on_loop_sym (d : W) : on_loop (alpha d) = on_loop d.
Proof.
have inj := inj_eq (inv_inj (@matched_back _ a)).
case: d => [x|b] //; rewrite -[alpha _]/(inl (val a x) : dart).
rewrite -[LHS]/((val a x == e) || (val a x == val a e)) -[RHS]/((x == e) || (x == val a e)).
by rewrite inj orbC -{2}(matched_back a e) inj.
Qed.

Fixpoint sheet w (d : W) b := if w is j :: w' then sheet w' (motion j d) (b (+) on_loop (iter j sigma d)) else b.

Lemma quiet_rcons w j (d : W) b : quiet on_loop (rcons w j) d b =
  quiet on_loop w d b && (at_same_vertex start (motion j (walk w d)) ==>
                          ~~ (sheet w d b (+) on_loop (iter j sigma (walk w d)))).
Proof. by elim: w d b => [|i w IH] d b /=; rewrite ?andbT // IH andbA. Qed.

Lemma sheet_rcons w j (d : W) b : sheet (rcons w j) d b = sheet w d b (+) on_loop (iter j sigma (walk w d)).
Proof. by elim: w d b => [|i w IH] d b /=. Qed.

Lemma apart_from_v0 (d : W) : d <> at_v0 -> at_same_vertex start d = false.
Proof. by move=> n; rewrite old_vertexE; case: d n => [i|[]]. Qed.

Definition upper p := match p with
  | Home => false | Inside _ => false
  | Lost e' _ => on_loop (inl e')
  | Deep e' o => on_loop (inl e') (+) on_loop (turned_by o (inl (val a e')))
  end.

Lemma still_unknown s j o : end_told (knows_after s j o) e = None -> end_told s e = None.
Proof.
rewrite /knows_after; case: (whereabouts_of s) => [|d|e' o'|e' o'] //.
- by case: (turned_by _ _) => [x|b] //; case: (end_told s x).
- case: ifP => // _; case: o.2 => // _; case: pickP => // y _ /=; rewrite /joined_ends.
  by case: ifP => // _; case: ifP.
Qed.

Lemma elsewhere x : x <> e -> val a x <> e -> on_loop (inl x) = false.
Proof.
move=> n n'; rewrite /on_loop -[LHS]/((x == e) || (x == val a e)); apply/norP; split; apply/eqP=> // h.
by apply: n'; rewrite h matched_back.
Qed.

Lemma sheet_step d s j : let d' := motion_in (worlds a) j d in let s' := knows_after s j (senses a d') in
  true_of a d s -> (forall e o, whereabouts_of s = Deep e o -> j %% loop_ring = 0) -> end_told s' e = None ->
  upper (whereabouts_of s) (+) on_loop (turned_by j d) = upper (whereabouts_of s') /\
    (d' = at_v0 -> upper (whereabouts_of s') = false).
Proof.
move=> d' s' T back K; have Ks := still_unknown K; have T' := learns_true T back; move: K T'.
case: T => tp ti tq kt lu; rewrite {}/s' {}/d' motion_from /knows_after.
case P: (whereabouts_of s) tp ti lu back => [|x|e1 o|e1 o] tp ti lu back.
- by move=> _ _; rewrite tp /turned_by turn_v0.
- have n : d <> at_v0 by apply: ti.
  have /not_inr[t|[e1 t]] := turned_inside (j := j) n; rewrite tp in t; rewrite tp t; first by split.
  case K: (end_told s e1) => [y|] _ _ /=; last by split=> // [[]].
  rewrite elsewhere ?(tq _ _ K) => [||]; first by split.
    by move=> e1e; rewrite e1e Ks in K.
  by move=> ye; rewrite ye in K; have := kt _ _ K; rewrite Ks.
- have n : inl (val a e1) <> at_v0 by [].
  rewrite tp turned_byD; case: eqP => [z|nz].
    by move=> _ _; rewrite full_turn // [upper _]/= -(on_loop_sym (inl e1)) addbb.
  case: (turned_by (o + j) (inl (val a e1)) =P inr true) => [h|h]; last first.
    have m := test_misses h; rewrite senses_inside // away_none /= => _ _; split=> //.
  rewrite (test_hits a h) senses_v0; case S: (home_percept _).2 => [b|]; last by have := home_some.
  case: pickP => [y _|no]; last by have := no (val a e1); rewrite h eqxx.
  move=> K [_ _ tq' _ _] /=; rewrite h addbF; split=> //; rewrite elsewhere //.
    by move=> e1e; move: K; rewrite /= /joined_ends e1e eqxx.
  move=> e1e; move: K; have := tq' e1 y; rewrite /= /joined_ends eqxx => /(_ erefl) <-.
  by rewrite e1e; case: eqP => // _; rewrite eqxx.
have j0 := back _ _ erefl; rewrite full_turn //; last by apply: ti.
move=> _ _ /=; rewrite tp on_loop_sym addbK; split=> // h.
have m : turned_by o (inl (val a e1)) <> at_v0 by exact: turned_inside.
by case: m; exact: etrans (esym (@alphaK (hanging a) _)) h.
Qed.

Lemma loop_stays_open seen d s : gets_to a seen d s -> end_told s e = None -> exists t,
  [/\ size seen = (size t).+1, d = walk (unzip1 t) (start : W), quiet on_loop (unzip1 t) start false &
      sheet (unzip1 t) start false = upper (whereabouts_of s)] /\
  forall n t' r z, explore_in a n seen d = (t', r, z) -> episode_in a (size t + n) = (t ++ t', r, z).
Proof.
elim=> [|{}seen {}d {}s j S IH Xj] K; first by exists [::].
have Ks := still_unknown K; have [t [[sz w Q sh] R]] := IH Ks; have T := gets_to_true S.
set d' := motion_in _ _ _ in K *; exists (rcons t (j, senses a d')).
have -> : unzip1 (rcons t (j, senses a d')) = rcons (unzip1 t) j by rewrite /unzip1 map_rcons.
have back e1 o : whereabouts_of s = Deep e1 o -> j %% loop_ring = 0 by move=> P; exact: careful S P Xj.
have [sh' home] := sheet_step T back K.
split; last by move=> n t' r z R'; rewrite size_rcons addSnnS cat_rcons; apply: R; rewrite /= Xj R'.
split; first by rewrite !size_rcons sz.
- by rewrite walk_rcons -w.
- rewrite quiet_rcons Q -w /=; apply/implyP=> v; rewrite sh sh' home //; case: (d' =P at_v0) => // n.
  by rewrite apart_from_v0 in v.
by rewrite sheet_rcons sh -w -sh'.
Qed.
Lemma two_sheets : connect (adjacent (@voltage_sigma W) (voltage_alpha on_loop)) (start, false) (start, true).
Proof.
have turn (x y : W) b : x <> at_v0 -> y <> at_v0 ->
    connect (adjacent (@voltage_sigma W) (voltage_alpha on_loop)) (x, b) (y, b).
  move=> nx ny; have /iter_findex <- := one_vertex (a := a) nx ny.
  elim: (findex _ _ _) => // j IH; exact: connect_trans IH (reach_sigma on_loop (_, b)).
have cross (x : W) b (y : W) b' : y = alpha x -> b' = b (+) on_loop x ->
    connect (adjacent (@voltage_sigma W) (voltage_alpha on_loop)) (x, b) (y, b').
  by move=> -> ->; exact: (reach_alpha on_loop (x, b)).
apply: connect_trans (cross at_v0 false (inr true) false _ _) _ => //.
apply: connect_trans (turn _ (inl e) _ _ _) _ => //.
apply: connect_trans (cross (inl e) false (inl (val a e)) true _ _) _ => //; first by rewrite /on_loop eqxx.
apply: connect_trans (turn _ (inr true) _ _ _) _ => //.
by apply: cross.
Qed.
End OpenLoop.

Variable meaning : E -> rooted_map.
Hypothesis finds_maps : forall V : lighthouse_world, finds_map meaning X (rooted (@start V)) (@percept_of V).

Lemma loops_are_closed a seen d s answer : gets_to a seen d s -> X seen = Stop answer ->
  forall e, end_told s e <> None.
Proof.
move=> S Xe e K; have [t [[sz w Q sh] R]] := loop_stays_open S K.
have Re : episode_in a (size t + 0) = (t ++ [::], Some answer, d) by apply: R; rewrite /= Xe.
rewrite cats0 in Re; have A := episode_agrees Re.
have B := quiet_agrees (@on_loop_sym a e) (two_sheets a e) A Q.
exact: voltage_not_same_map (one_log_one_map (finds_maps _) (finds_maps _) Re A B).
Qed.

(* ---- The adversary: a pair of ends that is tested is no loop, as long as that can be ---- *)
Implicit Types A : rel loop_end.
Definition allows A a := [forall x, A x (val a x)].
Definition any_pair : rel loop_end := fun x y => x != y.
Definition ends_known s := [set x | end_told s x].
Definition still_due p := match p with Home => 0 | Inside _ => 1 | Lost _ _ => 2 | Deep _ _ => 1 end.
Definition paid A s :=
  4 * (#|graph_edges any_pair| - #|graph_edges A|) + 3 * #|ends_known s| + 2 * still_due (whereabouts_of s).

Lemma allowsP A a : reflect (forall x, A x (val a x)) (allows A a).
Proof. exact: forallP. Qed.

Lemma pairs_counted : c * (2 * c - 1) <= #|graph_edges any_pair|.
Proof.
have <- : 'C(#|{: loop_end}|, 2) = c * (2 * c - 1).
  by rewrite card_ord bin2 (_ : k.*2.+2 = c.*2) // -doubleMl doubleK mul2n subn1.
rewrite -cardsT -cards_draws; apply: subset_leq_card; apply/subsetP=> B.
rewrite inE => /andP[_ /cards2P[x [y [n ->]]]]; by apply/imsetP; exists (x, y).
Qed.

Section Tested.
Variables (A : rel loop_end) (e : loop_end) (o : nat).
Definition ruled_out x y :=
  ((x == e) && (turned_by o (inl y) == inr true)) || ((y == e) && (turned_by o (inl x) == inr true)).
Definition without x y := A x y && ~~ ruled_out x y.

Lemma without_sym : symmetric A -> symmetric without.
Proof. by move=> S x y; rewrite /without S /ruled_out orbC. Qed.

Lemma without_edges : #|graph_edges A| <= #|graph_edges without|.+1.
Proof.
pose gone : {set {set loop_end}} := [set [set e; y] | y : loop_end & turned_by o (inl y) == inr true].
have le1 : #|gone| <= 1.
  rewrite (leq_trans (leq_imset_card _ _)) //; apply/card_le1P => y + z; rewrite !inE => /eqP ty.
  apply/idP/eqP=> [/eqP tz|->]; last exact/eqP.
  by have := @turned_inj o _ _ (etrans tz (esym ty)); case.
apply: leq_trans (_ : #|gone :|: graph_edges without| <= _); last first.
  by apply: leq_trans (leq_card_setU _ _) _; exact: (leq_add le1 (leqnn _)).
apply: subset_leq_card; apply/subsetP=> B /imsetP[[x y] Axy ->]; rewrite inE.
case R: (ruled_out x y); last by apply/orP; right; apply/imsetP; exists (x, y); rewrite // inE /without /= R andbT.
apply/orP; left; case/orP: R => /andP[/eqP-> t]; apply/imsetP; first by exists y; rewrite ?inE.
by exists x; rewrite ?inE // setUC.
Qed.

Lemma without_allows a : allows without a = allows A a && (turned_by o (inl (val a e)) != inr true).
Proof.
apply/allowsP/andP=> [H|[/allowsP H n] x].
  split; first by apply/allowsP=> x; have /andP[] := H x.
  by have /andP[_] := H e; rewrite /ruled_out eqxx /= negb_or => /andP[].
rewrite /without H /= /ruled_out negb_or; apply/andP; split; rewrite negb_and.
  by case: (x =P e) => //= ->.
case: (val a x =P e) => //= xe; apply: contra n => /eqP t; apply/eqP; rewrite -t -xe.
by rewrite matched_back.
Qed.
End Tested.

(* if no pair can be ruled out any more, there is one matching, and few pairs are left *)
Lemma few_pairs_left A seen s answer a0 : symmetric A -> irreflexive A -> allows A a0 ->
  (forall a, allows A a -> gets_to a seen (really a (whereabouts_of s)) s) -> X seen = Stop answer ->
  #|graph_edges A| <= c ^ 2.
Proof.
move=> As Ai A0 S Xs; have f0 : perfect_matching A (val a0).
  by split; [exact: matched_back | exact: matched_apart | exact/allowsP].
have c2 : (#|{: loop_end}|)./2 = c by rewrite card_ord (_ : k.*2.+2 = c.*2) // doubleK.
rewrite -c2; apply: (hetyei As Ai (f := val a0)); split=> // g [gK gN gA] x.
have gP : pairs_up setT (finfun g).
  by apply/pairs_upP; split=> y; rewrite !ffunE ?gK // (negbTE (gN y)) inE.
pose a : loop_matching k := Sub (finfun g) gP.
have Aa : allows A a by apply/allowsP=> y; rewrite ffunE.
suff -> : a0 = a by rewrite ffunE.
have [t [_ R]] := gets_to_stops (S _ A0) Xs; have [t' [_ R']] := gets_to_stops (S _ Aa) Xs.
have [n [u [y [z [F W I]]]]] := finds_maps (hanging a0); have [_ ey _] := explore_once R F.
have [n' [u' [y' [z' [F' W' I']]]]] := finds_maps (hanging a); have [_ ey' _] := explore_once R' F'.
subst y y'; apply: same_hanging; exact: same_map_join W (rooted_wellformed _) I I'.
Qed.

Variable limit : nat.
Hypothesis stops : forall a, stops_within X limit a.

Lemma adversary_stops A seen s answer a0 : symmetric A -> irreflexive A -> allows A a0 ->
  (forall a, allows A a -> gets_to a seen (really a (whereabouts_of s)) s) -> paid A s <= 2 * (size seen).-1 ->
  X seen = Stop answer ->
  exists a, forall fuel t e z, episode_in a fuel = (t, Some e, z) -> c * (2 * c + 1) <= size t.
Proof.
move=> As Ai A0 S cost Xs.
have cl := loops_are_closed (S _ A0) Xs; have few := few_pairs_left As Ai A0 S Xs.
have all : #|ends_known s| = 2 * c.
  rewrite (_ : ends_known s = setT) ?cardsT ?card_ord ?mul2n //; apply/setP=> x; rewrite !inE.
  by case K: (end_told s x) => //; have := cl x.
exists a0 => fuel t r z R; have [t0 [sz R0]] := gets_to_stops (S _ A0) Xs.
have [<- _ _] := explore_once R0 R; move: cost; rewrite sz /paid all [_.-1]/=.
have := pairs_counted; move: few; rewrite expnS expn1 mulnBr muln1.
move: (#|graph_edges A|) (#|graph_edges any_pair|) (size t0) (still_due _) => a b l d'; clear.
by move: (k.+1) => C; rewrite mulnDr muln1 mulnCA; move: (C * C) => q; numbers.
Qed.

Lemma adversary n A seen s : symmetric A -> irreflexive A -> (exists a, allows A a) ->
  (forall a, allows A a -> gets_to a seen (really a (whereabouts_of s)) s) ->
  paid A s <= 2 * (size seen).-1 -> limit < size seen + n ->
  exists a, forall fuel t e z, episode_in a fuel = (t, Some e, z) -> c * (2 * c + 1) <= size t.
Proof.
elim: n A seen s => [|n IH] A seen s As Ai [a0 A0] S cost le; case Xs: (X seen) => [j|answer].
- have [t [r [z R]]] := stops a0; have := gets_to_goes_on (S _ A0) Xs R.
  by rewrite leqNgt -(addn0 (size seen)) le.
- exact: adversary_stops As Ai A0 S cost Xs.
- have next A' o : symmetric A' -> irreflexive A' -> (exists a, allows A' a) ->
      (forall a, allows A' a -> allows A a /\ senses a (motion_in (worlds a) j (really a (whereabouts_of s))) = o) ->
      paid A' (knows_after s j o) <= 2 * size seen ->
      exists a, forall fuel t e z, episode_in a fuel = (t, Some e, z) -> c * (2 * c + 1) <= size t.
    move=> s' i' ex H p; apply: (IH A' (rcons seen o) (knows_after s j o)) => //.
    - move=> a Aa; have [{}Aa h] := H a Aa; have N := gets_to_next (S a Aa) Xs; rewrite h in N.
      by have [tp _ _ _ _] := gets_to_true N; rewrite -tp.
    - by rewrite size_rcons.
    - by rewrite size_rcons addSnnS.
  have [tp ti tq kt lu] := gets_to_true (S _ A0).
  have m0 : (size seen).-1.+1 = size seen by rewrite prednK //; have [t [-> _]] := gets_to_episode (S _ A0).
  have away (a : loop_matching k) : motion_in (worlds a) j (really a (whereabouts_of s)) <> at_v0 ->
    senses a (motion_in (worlds a) j (really a (whereabouts_of s))) = away_percept (nested k) by exact: senses_inside.
  have home (a : loop_matching k) : motion_in (worlds a) j (really a (whereabouts_of s)) = at_v0 ->
    senses a (motion_in (worlds a) j (really a (whereabouts_of s))) = home_percept (nested k).
    by move=> ->; exact: senses_v0.
  have somewhere : exists a, allows A a by exists a0.
  case P: (whereabouts_of s) tp ti => [|d|e o|e o] tp ti.
  + apply: (next A (away_percept (nested k))) => // [a Aa|].
      by split=> //; apply: away; rewrite P motion_from /turned_by turn_v0.
    by move: cost; rewrite /paid /ends_known /knows_after P /= -m0; clear; numbers.
  + have n0 : d <> at_v0 by exact: ti.
    have nj := turned_inside (j := j) n0; case T: (turned_by j d) => [e|b].
      apply: (next A (away_percept (nested k))) => // [a Aa|].
        by split=> //; apply: away; rewrite P motion_from T.
      move: cost; rewrite /paid /ends_known /knows_after P T.
      by case: (end_told s e) => [y|] /=; rewrite -m0; clear; numbers.
    apply: (next A (home_percept (nested k))) => // [a Aa|].
      by split=> //; apply: home; rewrite P motion_from T; case: b T => // T; rewrite T in nj.
    by move: cost; rewrite /paid /ends_known /knows_after P T /= -m0; clear; numbers.
  + case: ((o + j) %% loop_ring =P 0) => [z|nz].
      apply: (next A (away_percept (nested k))) => // [a Aa|].
        by split=> //; apply: away; rewrite P motion_from turned_byD full_turn.
      by move: cost; rewrite /paid /ends_known /knows_after P z /= -m0; clear; numbers.
    have nz' : ((o + j) %% loop_ring == 0) = false by apply/eqP.
    case: (boolP [exists a, allows A a && (turned_by (o + j) (inl (val a e)) != inr true)]) => [/existsP[a1 A1]|no].
      apply: (next (without A e (o + j)) (away_percept (nested k))).
      * exact: without_sym.
      * by move=> x; rewrite /without Ai.
      * by exists a1; rewrite without_allows.
      * move=> a; rewrite without_allows => /andP[Aa /eqP m]; split=> //; apply: away.
        by rewrite P motion_from turned_byD; exact: test_misses.
      have := without_edges A e (o + j); move: cost; rewrite /paid /ends_known /knows_after P nz' away_none /= -m0.
      by clear; numbers.
    have hits a : allows A a -> turned_by (o + j) (inl (val a e)) = inr true.
      by move=> Aa; apply/eqP; have /existsPn/(_ a) := no; rewrite Aa negbK.
    have e_new : end_told s e = None by apply: lu; rewrite P.
    apply: (next A (home_percept (nested k))) => // [a Aa|].
      by split=> //; apply: home; rewrite P motion_from turned_byD (hits a Aa).
    rewrite /knows_after P nz'; case H: (home_percept _).2 => [b|]; last by have := home_some.
    case: pickP => [y /eqP ty|none]; last by have := none (val a0 e); rewrite (hits a0 A0) eqxx.
    have ey : y = val a0 e by have := @turned_inj (o + j) _ _ (etrans ty (esym (hits a0 A0))); case.
    have ne : y != e by rewrite ey; exact: matched_apart.
    have y_new : end_told s y = None.
      case K: (end_told s y) => [x|] //; have xe : x = e by rewrite -(tq _ _ K) ey matched_back.
      by have := kt _ _ K; rewrite xe e_new.
    have more : #|ends_known (Know Home (joined_ends e y (end_told s)))| = #|ends_known s|.+2.
      have -> : ends_known (Know Home (joined_ends e y (end_told s))) = e |: (y |: ends_known s).
        by apply/setP=> x; rewrite !inE /= /joined_ends; case: eqP => //= _; case: eqP.
      by rewrite !cardsU1 !inE e_new y_new orbF eq_sym ne.
    by move: cost; rewrite /paid more P /= -m0; clear; numbers.
  have j0 : j %% loop_ring = 0 by exact: careful (S _ A0) P Xs.
  have back a : allows A a -> motion_in (worlds a) j (really a (whereabouts_of s)) = turned_by o (inl (val a e)).
    move=> Aa; have [_ ti' _ _ _] := gets_to_true (S _ Aa); rewrite motion_from full_turn // ?P; first exact: alphaK.
    by rewrite -P; apply: ti'; rewrite P.
  apply: (next A (away_percept (nested k))) => // [a Aa|].
    by split=> //; apply: away; rewrite back //; exact: turned_inside.
  by move: cost; rewrite /paid /ends_known /knows_after P /= -m0; clear; numbers.
exact: adversary_stops As Ai A0 S cost Xs.
Qed.
End Explorer.
End Cautious.

Theorem cautious_needs k E (meaning : E -> rooted_map) (X : explorer percept E) : cautious k X ->
  (forall V : lighthouse_world, finds_map meaning X (rooted (@start V)) (@percept_of V)) ->
  exists a : loop_matching k, forall fuel t e z,
  episode X (rooted (@start (hanging a))) (@percept_of (hanging a)) fuel = (t, Some e, z) ->
  k.+1 * (2 * k.+1 + 1) <= size t.
Proof.
move=> careful finds; have some (a : loop_matching k) : exists n, stops_within X n a.
  by have [n [t [e [z [R _ _]]]]] := finds (hanging a); exists n, t, e, z.
have [fuel F] := fin_all_exists some; pose n := \max_a fuel a.
have stops (a : loop_matching k) : stops_within X n a.
  have [t [e [z R]]] := F a; exists t, e, z.
  by rewrite -(subnKC (leq_bigmax a : fuel a <= n)); exact: explore_more R.
apply: (adversary careful finds stops (n := n) (A := @any_pair k) (seen := [:: home_percept (nested k)])
  (s := Know (@Home k) (fun=> None))) => //.
- by move=> x y; rewrite /any_pair eq_sym.
- by move=> x; rewrite /any_pair eqxx.
- by exists (nested k); apply/allowsP=> x; rewrite /any_pair eq_sym matched_apart.
- by move=> a _; rewrite -(senses_v0 a); exact: gets_to_first.
by rewrite /paid subnn /ends_known (_ : [set x | None] = set0) ?cards0 //; apply/setP=> x; rewrite !inE.
Qed.
