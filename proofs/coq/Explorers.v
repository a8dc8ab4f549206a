(* ---------------------------------------------------------------------------------------------
   Explorers and programs.

     explore_walk       the robot is where its motions lead.
     chosen_episode     an explorer may be chosen by the first percept.
     explore_more       once an explorer has stopped a larger budget changes nothing.
     right_finds_map    an explorer that is right finds the map.

     program A          a robot's control: Return x, or Go k f: make motion k and go on with f of
                        what is sensed then.  An algorithm written so sees percepts and nothing
                        else.
     bind p f           first p, then f of its result.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model RootedMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Episodes.
Variables (P E : Type) (X : explorer P E) (M : rooted_map) (obs : carrier M -> P).
Local Notation explore := (explore X M obs).

(* the robot is where its motions lead *)
Lemma explore_walk fuel seen d :
  (explore fuel seen d).2 = walk_in M (unzip1 (explore fuel seen d).1.1) d.
Proof.
elim: fuel seen d => [|fl IH] h d /=; case: (X h) => //= k.
have := IH (rcons h (obs (motion_in M k d))) (motion_in M k d).
by case: (explore _ _ _) => [[t e] z] /= ->.
Qed.

(* once it has stopped, a larger budget changes nothing *)
Lemma explore_more fuel k seen d t e z :
  explore fuel seen d = (t, Some e, z) -> explore (fuel + k) seen d = (t, Some e, z).
Proof.
elim: fuel seen d t => [|fl IH] h d t; first by rewrite add0n; case: k => [|k] /=; case: (X h).
rewrite addSn /=; case: (X h) => //= j.
case R: (explore _ _ _) => [[t' [e'|]] z'] //= [<- ee zz]; subst e' z'.
by rewrite (IH _ _ _ R).
Qed.

(* so it stops in one way only *)
Lemma explore_once n n' seen d t t' e e' z z' : explore n seen d = (t, Some e, z) ->
  explore n' seen d = (t', Some e', z') -> [/\ t = t', e = e' & z = z'].
Proof. by move/(explore_more n')=> R /(explore_more n); rewrite addnC R => -[-> -> ->]. Qed.
End Episodes.

(* an explorer that looks at its first percept to choose another one is, from then on, that one *)
Lemma chosen_episode P E (F : P -> explorer P E) o (M : rooted_map) (obs : carrier M -> P) budget :
  episode (fun seen => F (head o seen) seen) M obs budget = episode (F (obs (root M))) M obs budget.
Proof.
rewrite /episode; set a := obs (root M).
suff H seen d : explore (fun seen => F (head o seen) seen) M obs budget (a :: seen) d
    = explore (F a) M obs budget (a :: seen) d by exact: H.
by elim: budget seen d => [|n IH] seen d /=; case: (F a _) => // k; rewrite IH.
Qed.

(* who knows the place knows the map *)
Lemma right_finds_map P E (meaning : E -> rooted_map) (X : explorer P E) M (obs : carrier M -> P) :
  right meaning X M obs -> finds_map meaning X M obs.
Proof.
move=> [n [t [a [z [R W I]]]]]; exists n, t, a, z; split=> //; exists z => //.
by have [f [g [F _ /= <-]]] := I; have [] := F _ (wellformed_root W).
Qed.

Lemma explore_ext P E (X : explorer P E) M (o1 o2 : carrier M -> P) : (forall x, o1 x = o2 x) ->
  forall fuel seen d, explore X M o1 fuel seen d = explore X M o2 fuel seen d.
Proof. by move=> H; elim=> [|fl IH] h d /=; case: (X h) => // k; rewrite H IH. Qed.

(* ---- Programs ---- *)
Inductive program P A := Return (x : A) | Go (k : nat) (f : P -> program P A).
Arguments Return {P A} x.
Arguments Go {P A} k f.

Fixpoint bind P A B (p : program P A) (f : A -> program P B) : program P B :=
  match p with
  | Return x => f x
  | Go k g => Go k (fun o => bind (g o) f)
  end.
