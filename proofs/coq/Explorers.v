(* ---------------------------------------------------------------------------------------------
   Explorers.

     action, explorer   an explorer is any function from the percepts so far (the first one first)
                        to an action: a motion, or to stop with an answer of any type.  It never
                        holds a world, so whatever holds of all explorers holds of all algorithms.
     episode X M obs n  explorer X in the rooted map M, where obs d is sensed in dart d, for at
                        most n motions: the transcript (motion, percept), the answer, the robot's
                        true dart. No answer: the n motions were not enough.
     right              it stops, and its answer denotes a rooted map that is isomorphic to the
                        world seen from the robot's true dart: the same map, and the right place
                        in it.

     program A          a robot's control: Return x, or Go k f: make motion k and go on with f of
                        what is sensed then.  An algorithm written so sees percepts and nothing
                        else.
     bind p f           first p, then f of its result.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import RootedMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive action E := Move (k : nat) | Stop (answer : E).
Arguments Move {E} k.
Arguments Stop {E} answer.
Definition explorer P E := seq P -> action E.

Section Episodes.
Variables (P E : Type) (meaning : E -> rooted_map) (X : explorer P E).
Variables (M : rooted_map) (obs : carrier M -> P).

(* seen: the percepts so far; d: the robot's true dart *)
Fixpoint explore fuel (seen : seq P) d : seq (nat * P) * option E * carrier M :=
  match X seen with
  | Stop answer => ([::], Some answer, d)
  | Move k =>
      if fuel is fuel'.+1 then
        let d' := motion_in M k d in
        let: (transcript, answer, z) := explore fuel' (rcons seen (obs d')) d' in
        ((k, obs d') :: transcript, answer, z)
      else ([::], None, d)
  end.
Definition episode fuel := explore fuel [:: obs (root M)] (root M).

Definition right := exists fuel transcript answer z,
  [/\ episode fuel = (transcript, Some answer, z), wellformed (meaning answer) &
      isomorphic (meaning answer) (rooted_at M z)].

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
End Episodes.

Arguments explore {P E} X M obs fuel seen d.
Arguments episode {P E} X M obs fuel.
Arguments right {P E} meaning X M obs.

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
