(* ---------------------------------------------------------------------------------------------
   In how many ways things are put together by twos, and how many worlds an explorer tells apart.

     pairs_up U b         b puts the members of U together by twos, and leaves all else alone.
     pairings_counted     there are (#|U| - 1)(#|U| - 3)... such b (pairings, MassFormula.v).

     logs_differ b seen d A   worlds M i, one for each member of a finite type, all with the percepts `seen`
                          so far, the robot in the dart d i: in no two worlds of the set A explorer X has
                          the same transcript and the same answer, with at most b motions more.
     told_at_once         without a motion no two worlds are told apart.
     told_step            after a motion: those in which the same is sensed then.
     one_is_costly        an explorer that finds the maps of different worlds makes, in one of them, as many
                          motions as are needed to tell them apart.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model RootedMaps Explorers MassFormula.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Put together by twos ---- *)
Section Pairings.
Variable T : finType.
Implicit Types (U : {set T}) (b c : {ffun T -> T}) (x y z : T).

Definition pairs_up U b := [forall x, b (b x) == x] && [forall x, (b x == x) == (x \notin U)].

Lemma pairs_upP U b : reflect (involutive b /\ forall x, (b x == x) = (x \notin U)) (pairs_up U b).
Proof.
apply: (iffP andP) => [[/forallP K /forallP N]|[K N]].
  by split=> x; [exact/eqP/K | have /eqP := N x].
by split; apply/forallP=> x; rewrite ?K ?N.
Qed.

Lemma pairs_up_pair U x y : x \in U -> y \in U -> y != x ->
  #|[set b | pairs_up U b & b x == y]| = #|[set b | pairs_up (U :\: [set x; y]) b]|.
Proof.
move=> xU yU yx; pose join c : {ffun T -> T} := [ffun z => if z == x then y else if z == y then x else c z].
have out c z : pairs_up (U :\: [set x; y]) c -> z \in [set x; y] -> c z = z.
  by case/pairs_upP=> _ N m; apply/eqP; rewrite N !inE; rewrite !inE in m; rewrite m.
have inj : {in [set b | pairs_up (U :\: [set x; y]) b] &, injective join}.
  move=> c c'; rewrite !inE => g g' /ffunP E; apply/ffunP=> z; have := E z; rewrite !ffunE.
  have [->|zx] := eqVneq z x; first by rewrite !out ?inE ?eqxx.
  by have [->|zy] := eqVneq z y; first by rewrite !out ?inE ?eqxx ?orbT.
rewrite -(card_in_imset inj); apply: eq_card => b; rewrite !inE.
apply/andP/imsetP=> [[/pairs_upP[K N] /eqP bx]|[c]].
  have bz : b y = x by rewrite -bx K.
  exists [ffun z => if (z == x) || (z == y) then z else b z]; last first.
    apply/ffunP=> z; rewrite !ffunE; have [->|zx] := eqVneq z x; first by rewrite bx.
    by have [->|zy] := eqVneq z y.
  rewrite inE; apply/pairs_upP; split=> z; rewrite ?ffunE.
  - have bij : (b z == x) || (b z == y) = (z == y) || (z == x).
      by congr (_ || _); [rewrite -{1}bz | rewrite -{1}bx]; rewrite (inj_eq (inv_inj K)).
    have [->|zx] /= := eqVneq z x; first by rewrite eqxx.
    have [->|zy] /= := eqVneq z y; first by rewrite eqxx orbT.
    by rewrite bij (negbTE zx) (negbTE zy) K.
  rewrite !inE; have [->|zx] /= := eqVneq z x; first by rewrite eqxx.
  by have [->|zy] /= := eqVneq z y; [rewrite eqxx | rewrite N].
rewrite inE => /[dup] g /pairs_upP[K N] ->; split; last by rewrite ffunE eqxx.
apply/pairs_upP; split=> z; rewrite ?ffunE.
  have cx : c x = x by apply: out g _; rewrite !inE eqxx.
  have cy : c y = y by apply: out g _; rewrite !inE eqxx orbT.
  have [->|zx] := eqVneq z x; first by rewrite (negbTE yx) eqxx.
  have [->|zy] := eqVneq z y; first by rewrite eqxx.
  have -> : (c z == x) = false by rewrite -[X in _ == X]cx (inj_eq (inv_inj K)) (negbTE zx).
  by have -> : (c z == y) = false by rewrite -[X in _ == X]cy (inj_eq (inv_inj K)) (negbTE zy).
have [->|zx] := eqVneq z x; first by rewrite (negbTE yx) xU.
have [->|zy] := eqVneq z y; first by rewrite eq_sym (negbTE yx) yU.
by rewrite N !inE (negbTE zx) (negbTE zy).
Qed.

Theorem pairings_counted U : #|[set b | pairs_up U b]| = pairings #|U|.
Proof.
have [k] := ubnP #|U|; elim: k U => // k IH U; have [->|[x xU]] := set_0Vmem U.
  move=> _; rewrite cards0 (_ : [set b | pairs_up set0 b] = [set [ffun z => z]]) ?cards1 //.
  apply/setP=> b; rewrite !inE; apply/pairs_upP/eqP=> [[_ N]|->].
    by apply/ffunP=> z; rewrite ffunE; apply/eqP; rewrite N inE.
  by split=> z; rewrite !ffunE // inE eqxx.
move=> lk; pose ends := U :\ x; have cU : #|U| = #|ends|.+1 by rewrite (cardsD1 x U) xU.
have -> : #|[set b | pairs_up U b]| = \sum_(y in ends) #|[set b | pairs_up U b & b x == y]|.
  rewrite -sum1_card (partition_big (fun b : {ffun T -> T} => b x) (mem ends)) /= => [|b].
    by apply: eq_bigr => y yP; rewrite -sum1_card; apply: eq_bigl => b; rewrite !inE.
  rewrite inE => /pairs_upP[K N]; rewrite !inE N xU /=.
  by have := N (b x); rewrite K eq_sym N xU /= => /esym; case: (b x \in U).
have rest y : y \in ends -> #|U :\: [set x; y]| = #|ends|.-1.
  move=> ye; rewrite setUC -setDDl -/ends (cardsD1 y ends) ye /=.
  by apply: eq_card => z; rewrite !inE; case: (z == y) (z == x) => [] [] //=; rewrite ?andbF.
rewrite (eq_bigr (fun=> pairings #|ends|.-1)) => [|y ye]; last first.
  have [yx yU] : y != x /\ y \in U by move: ye; rewrite !inE => /andP.
  rewrite pairs_up_pair // IH rest //; apply: leq_trans (_ : _ < #|U|) _; last by [].
  by rewrite cU ltnS leq_pred.
by rewrite sum_nat_const cU; case: #|ends|.
Qed.
End Pairings.

(* ---- Told apart ---- *)
Lemma explore_exact P E (X : explorer P E) M (obs : carrier M -> P) fuel seen d t e z :
  explore X M obs fuel seen d = (t, Some e, z) -> explore X M obs (size t) seen d = (t, Some e, z).
Proof.
elim: fuel seen d t => [|fuel IH] seen d t /=; case E0: (X seen) => [k|a] //.
- by case=> <- <- <- /=; rewrite E0.
- case R: (explore _ _ _ _ _ _) => [[t' a'] z'] [<- A Z]; subst a' z'.
  by rewrite /= E0 (IH _ _ _ R).
by case=> <- <- <- /=; rewrite E0.
Qed.

Section ToldApart.
Variables (I : finType) (P : eqType) (E : Type) (X : explorer P E).
Variables (M : I -> rooted_map) (obs : forall i, carrier (M i) -> P).
Implicit Types (A : {set I}) (d : forall i, carrier (M i)).

Definition log_with b seen d i := (explore X (M i) (@obs i) b seen (d i)).1.
Definition logs_differ b seen d A := {in A &, injective (log_with b seen d)}.

Lemma told_at_once b seen d A :
  (forall i j, i \in A -> j \in A -> log_with b seen d i = log_with b seen d j) ->
  logs_differ b seen d A -> #|A| <= 1.
Proof.
by move=> same T; apply/card_le1_eqP=> i j iA jA; apply: T => //; exact: same.
Qed.

Lemma told_by_no_motion seen d A : logs_differ 0 seen d A -> #|A| <= 1.
Proof. by apply: told_at_once => i j _ _; rewrite /log_with /=; case: (X seen). Qed.

Lemma told_by_stopping b seen d A e : X seen = Stop e -> logs_differ b seen d A -> #|A| <= 1.
Proof. by move=> s; apply: told_at_once => i j _ _; rewrite /log_with; case: b => [|b] /=; rewrite s. Qed.

Definition led k d i := motion_in (M i) k (d i).
Arguments led k d i : clear implicits.

Lemma told_step b seen d A k o : X seen = Move k -> logs_differ b.+1 seen d A ->
  logs_differ b (rcons seen o) (led k d) [set i in A | obs (led k d i) == o].
Proof.
move=> s T i j; rewrite !inE => /andP[iA /eqP oi] /andP[jA /eqP oj] S; apply: T => //; move: S.
rewrite /log_with /= s -/(led k d i) -/(led k d j) oi oj.
by do 2 case: (explore _ _ _ _ _ _) => [[? ?] ?] /=; case=> -> ->.
Qed.

(* nothing new is sensed *)
Lemma told_on b seen d A k o : X seen = Move k -> (forall i, i \in A -> obs (led k d i) = o) ->
  logs_differ b.+1 seen d A -> logs_differ b (rcons seen o) (led k d) A.
Proof.
move=> s S T; rewrite (_ : A = [set i in A | obs (led k d i) == o]); first exact: told_step T.
by apply/setP=> i; rewrite inE; case: (boolP (i \in A)) => // /S->; rewrite eqxx.
Qed.
End ToldApart.

Arguments led {I} M k d i.
Arguments log_with {I P E} X M obs b seen d i.
Arguments logs_differ {I P E} X M obs b seen d A.

(* ---- An explorer that finds the maps of different worlds tells them apart ---- *)
Section Finding.
Variables (I : finType) (P : eqType) (E : Type) (meaning : E -> rooted_map) (X : explorer P E).
Variables (M : I -> rooted_map) (obs : forall i, carrier (M i) -> P).
Hypothesis M_wellformed : forall i, wellformed (M i).
Hypothesis different : forall i j, same_map (M i) (M j) -> i = j.
Hypothesis finds_maps : forall i, finds_map meaning X (M i) (@obs i).

Lemma finding_tells b : (forall i, exists t e z, episode X (M i) (@obs i) b = (t, Some e, z)) ->
  injective (fun i => (episode X (M i) (@obs i) b).1).
Proof.
move=> stops i j; have [t [e [z R]]] := stops i; have [t' [e' [z' R']]] := stops j.
rewrite R R' => -[_ ee]; subst e'.
have [n [u [x [y [Q W S]]]]] := finds_maps i; have [_ ex _] := explore_once R Q.
have [n' [u' [x' [y' [Q' W' S']]]]] := finds_maps j; have [_ ex' _] := explore_once R' Q'.
by subst x x'; apply: different; exact: same_map_join W (M_wellformed i) S S'.
Qed.

(* so it is as long as that takes in one of them *)
Theorem one_is_costly (bound : nat -> nat) (i0 : I) :
  (forall b, injective (fun i => (episode X (M i) (@obs i) b).1) -> #|I| <= bound b) ->
  exists i, forall fuel t e z, episode X (M i) (@obs i) fuel = (t, Some e, z) -> #|I| <= bound (size t).
Proof.
move=> H; have stops i : exists n, exists t e z, episode X (M i) (@obs i) n = (t, Some e, z).
  by have [n [t [e [z [R _ _]]]]] := finds_maps i; exists n, t, e, z.
have [fuel Q] := fin_all_exists stops; pose walked i := size (episode X (M i) (@obs i) (fuel i)).1.1.
exists [arg max_(i > i0) walked i]; case: arg_maxnP => // i _ most n t e z R.
have -> : size t = walked i.
  by rewrite /walked; have [t' [e' [z' R']]] := Q i; have [-> _ _] := explore_once R R'; rewrite R'.
apply/H/finding_tells=> j; have [t' [e' [z' R']]] := Q j; exists t', e', z'.
have le : size t' <= walked i by apply: leq_trans (most j isT); rewrite /walked R'.
rewrite -(subnKC le); apply: explore_more; exact: explore_exact R'.
Qed.
End Finding.
