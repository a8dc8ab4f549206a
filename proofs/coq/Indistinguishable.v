(* ---------------------------------------------------------------------------------------------
   Indistinguishable worlds, and the general impossibility theorem.                  Section III

     percepts_in obs w d   what is sensed on the way of the motions w from d.
     alike x y             every list of motions gives equal percepts from x and from y.
   A bisimulation of two worlds is a relation R between their darts that holds of the start darts,
   implies equal percepts, and is kept by sigma and alpha.

     twins_episode         R a bisimulation: every explorer has the same transcript and the same
                           answer in both worlds.
     twins_impossible      hence an explorer that is right in both worlds exists only if they are
                           the same rooted map;
     twins_same_map        and one that finds the map of both only if it is the same map.
     seeds_do_not_help     an explorer with a seed or an oracle is a family of explorers: if no explorer
                           finds both maps, the chances that it finds the one and the other add up to
                           at most one.
     alike_percept, alike_sigma, alike_alpha, bisimulation_alike   alike is the largest bisimulation.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model RootedMaps Explorers.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Fixpoint percepts_in P (M : rooted_map) (obs : carrier M -> P) w d : seq P :=
  obs d :: (if w is k :: w' then percepts_in obs w' (motion_in M k d) else [::]).

Section Largest.
Variables (P : Type) (M N : rooted_map) (oM : carrier M -> P) (oN : carrier N -> P).
Hypotheses (WM : wellformed M) (WN : wellformed N).

Definition alike x y :=
  [/\ is_dart M x, is_dart N y & forall w, percepts_in oM w x = percepts_in oN w y].

Lemma alike_percept x y : alike x y -> oM x = oN y.
Proof. by case=> _ _ /(_ [::]) []. Qed.

Lemma alike_motion k x y : alike x y -> alike (motion_in M k x) (motion_in N k y).
Proof.
case=> dx dy H; split; [exact: is_dart_motion | exact: is_dart_motion |].
by move=> w; have [] := H (k :: w).
Qed.

Lemma alike_alpha x y : alike x y -> alike (alpha_of M x) (alpha_of N y).
Proof. exact: (@alike_motion 0). Qed.

(* there and back: motion 1 and then motion 0 *)
Lemma alike_sigma x y : alike x y -> alike (sigma_of M x) (sigma_of N y).
Proof.
move=> A; have [dx dy _] := A; have := alike_motion 0 (alike_motion 1 A); rewrite /motion_in /=.
rewrite !(wellformed_alphaK WM) ?(wellformed_alphaK WN) //; first exact: (wellformed_sigma WN).
exact: (wellformed_sigma WM).
Qed.

Lemma bisimulation_alike (R : carrier M -> carrier N -> Prop) :
  (forall x y, R x y -> [/\ is_dart M x, is_dart N y & oM x = oN y]) ->
  (forall x y, R x y -> R (sigma_of M x) (sigma_of N y)) ->
  (forall x y, R x y -> R (alpha_of M x) (alpha_of N y)) ->
  forall x y, R x y -> alike x y.
Proof.
move=> Ro Rs Ra x y Rxy; have [dx dy _] := Ro _ _ Rxy; split=> // w.
elim: w x y Rxy {dx dy} => [|k w IH] x y Rxy /=; have [_ _ ->] := Ro _ _ Rxy; congr (_ :: _).
by apply: IH; apply: Ra; elim: k => //= k; exact: Rs.
Qed.
End Largest.

Section Twins.
Variables (P E : Type) (meaning : E -> rooted_map) (X : explorer P E).
Variables (M N : rooted_map) (oM : carrier M -> P) (oN : carrier N -> P).
Variable R : carrier M -> carrier N -> Prop.
Hypothesis Ro : forall x y, R x y -> oM x = oN y.
Hypothesis Rs : forall x y, R x y -> R (sigma_of M x) (sigma_of N y).
Hypothesis Ra : forall x y, R x y -> R (alpha_of M x) (alpha_of N y).
Hypothesis R0 : R (root M) (root N).

Lemma bisimulation_motion k x y : R x y -> R (motion_in M k x) (motion_in N k y).
Proof. by move=> Rxy; apply: Ra; elim: k => //= k; exact: Rs. Qed.

Lemma bisimulation_explore fuel h x y :
  R x y -> (explore X M oM fuel h x).1 = (explore X N oN fuel h y).1.
Proof.
elim: fuel h x y => [|fl IH] h x y Rxy /=; case: (X h) => //= k.
have Rk := bisimulation_motion k Rxy.
have := IH (rcons h (oM (motion_in M k x))) _ _ Rk; rewrite (Ro Rk).
by case: (explore X M _ _ _ _) => [[t e] z]; case: (explore X N _ _ _ _) => [[t' e'] z'] /= [-> ->].
Qed.

Theorem twins_episode fuel : (episode X M oM fuel).1 = (episode X N oN fuel).1.
Proof. by rewrite /episode (Ro R0); exact: bisimulation_explore. Qed.

Theorem twins_impossible : wellformed M -> wellformed N ->
  right meaning X M oM -> right meaning X N oN -> isomorphic M N.
Proof.
move=> WM WN [f1 [t1 [e1 [z1 [E1 W1 I1]]]]] [f2 [t2 [e2 [z2 [E2 W2 I2]]]]].
have E1' := explore_more f2 E1; have E2' := explore_more f1 E2; rewrite addnC in E2'.
have := twins_episode (f1 + f2); rewrite /episode E1' E2' /= => -[tt ee]; subst t2 e2.
have r1 := explore_walk X oM (f1 + f2) [:: oM (root M)] (root M).
have r2 := explore_walk X oN (f1 + f2) [:: oN (root N)] (root N).
rewrite E1' /= in r1; rewrite E2' /= in r2; subst z1 z2.
have I := isomorphic_trans (isomorphic_sym W1 I1) I2.
have := isomorphic_back WM WN (wellformed_root WM) (wellformed_root WN) I.
by case: (M) (N) => ? ? ? ? ? [].
Qed.

Theorem twins_same_map : wellformed M ->
  finds_map meaning X M oM -> finds_map meaning X N oN -> same_map M N.
Proof.
move=> WM [n1 [t1 [e1 [z1 [E1 W1 I1]]]]] [n2 [t2 [e2 [z2 [E2 _ I2]]]]].
have E1' := explore_more n2 E1; have E2' := explore_more n1 E2; rewrite addnC in E2'.
have := twins_episode (n1 + n2); rewrite /episode E1' E2' /= => -[_ ee]; subst e2.
exact: same_map_join I1 I2.
Qed.
End Twins.

Theorem seeds_do_not_help P (M N : rooted_map) (oM : carrier M -> P) (oN : carrier N -> P)
    E (meaning : E -> rooted_map) (Seed : finType) (weight : Seed -> nat) (X : Seed -> explorer P E)
    (A B : {set Seed}) : no_explorer_finds_both oM oN ->
  (forall s, s \in A -> finds_map meaning (X s) M oM) ->
  (forall s, s \in B -> finds_map meaning (X s) N oN) ->
  \sum_(s in A) weight s + \sum_(s in B) weight s <= \sum_s weight s.
Proof.
move=> H FA FB; have D s : s \in A -> s \notin B.
  by move=> sA; apply/negP=> sB; apply: (H _ meaning (X s)); split; [exact: FA | exact: FB].
rewrite [X in _ <= X](bigID (mem A)) leq_add2l [X in _ <= X](bigID (mem B)) /=.
rewrite -[X in X <= _]addn0 leq_add // [X in _ <= X](eq_bigl (mem B)) // => s.
by rewrite andb_idl // => sB; apply: contraL (sB) => /D.
Qed.
