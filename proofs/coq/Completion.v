(* ---------------------------------------------------------------------------------------------
   Maps in which edges are missing, completed.                                          Section V

     completion           a map in which every dart without other end (o x = None) has been given one, by
                          a copy of a small piece T, a map with one dart `stem` too many.
     card_completion      how many darts it has.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Completion.
Variables (F : finType) (s : F -> F) (o : F -> option F).
Hypotheses (s_inj : injective s) (o_sym : forall x y, o x = Some y -> o y = Some x).
Hypothesis o_neq : forall x, o x <> Some x.
Hypothesis conn : forall x y, connect (fun u v => (v == s u) || (o u == Some v)) x y.
Variables (T : finType) (sT aT : T -> T) (stem : T).
Hypotheses (sT_inj : injective sT) (aTK : involutive aT).
Hypothesis aT_stem : forall t, (aT t == t) = (t == stem).
Hypothesis connT : forall t, connect (adjacent sT aT) stem t.

Definition loose := [finType of {x : F | o x == None}].
Definition as_loose x (e : o x == None) : loose := exist (fun y => o y == None) x e.
Definition completed := (F + loose * T)%type.
Definition completed_sigma (d : completed) : completed :=
  match d with inl x => inl (s x) | inr (l, t) => inr (l, sT t) end.
Definition completed_alpha (d : completed) : completed :=
  match d with
  | inl x => match insub x with
             | Some l => inr (l, stem)
             | None => inl (odflt x (o x))
             end
  | inr (l, t) => if t == stem then inl (val l) else inr (l, aT t)
  end.

Lemma completed_alpha_glued x y : o x = Some y -> completed_alpha (inl x) = inl y.
Proof. by move=> E /=; rewrite insubN E. Qed.

Lemma completed_sigma_inj : injective completed_sigma.
Proof. by move=> [x|[l t]] [y|[l' t']] //= [] => [/s_inj -> //|-> /sT_inj -> //]. Qed.

Lemma completed_alphaK : involutive completed_alpha.
Proof.
have stemE : aT stem = stem by apply/eqP; rewrite aT_stem.
move=> [x|[l t]] /=.
  case: insubP => [l _ <-|]; first by rewrite /= eqxx.
  by case E: (o x) => [y|] //= _; exact: completed_alpha_glued (o_sym E).
case: (t =P stem) => [->|/eqP ne] /=; first by rewrite valK.
have -> : (aT t == stem) = false; last by rewrite aTK.
by apply/negbTE/eqP=> E; move: ne; rewrite -aT_stem -{2}(aTK t) E stemE eqxx.
Qed.

Lemma completed_alpha_neq d : completed_alpha d != d.
Proof.
case: d => [x|[l t]] /=; last first.
  case: (t =P stem) => // /eqP; rewrite -aT_stem; apply: contra => /eqP[->] //.
case: insubP => [l _ _|] //; case E: (o x) => [y|] //= _.
by apply/eqP=> -[yx]; apply: (o_neq (x := x)); rewrite E yx.
Qed.

Lemma completed_connected x y : connect (adjacent completed_sigma completed_alpha) x y.
Proof.
set adj := adjacent _ _.
have stepa d : connect adj d (completed_alpha d) by apply: connect1;
  rewrite /adj /adjacent eqxx orbT.
have old u v : connect adj (inl u) (inl v).
  case/connectP: (conn u v) => p + ->; elim: p u => //= w p IH u /andP[H /IH]; apply: connect_trans.
  case/orP: H => /eqP H; first by rewrite H; apply: connect1; rewrite /adj /adjacent /= eqxx.
  by rewrite -(completed_alpha_glued H).
have out l t : connect adj (inl (val l)) (inr (l, t)).
  apply: (@connect_trans _ _ (inr (l, stem))).
    by have := stepa (inl (val l)); rewrite /= valK.
  case/connectP: (connT t) => p + ->; elim: p (stem) => //= w p IH u /andP[H /IH];
    apply: connect_trans.
  case/orP: H => /eqP->; first by apply: connect1; rewrite /adj /adjacent /= eqxx.
  case: (u =P stem) => [->|/eqP ne]; first by have /eqP-> : aT stem == stem by rewrite aT_stem.
  by have := stepa (inr (l, u)); rewrite /= (negbTE ne).
have back l t : connect adj (inr (l, t)) (inl (val l)).
  by rewrite /adj (adjacent_connect_sym completed_sigma_inj completed_alphaK); exact: out.
case: x y => [x|[l t]] [y|[l' t']].
- exact: old.
- exact: connect_trans (old x (val l')) (out l' t').
- exact: connect_trans (back l t) (old (val l) y).
exact: connect_trans (back l t) (connect_trans (old (val l) (val l')) (out l' t')).
Qed.

Definition completion :=
  CombinatorialMap completed_sigma_inj completed_alphaK completed_alpha_neq completed_connected.

Lemma card_completion : #|completion| = #|F| + #|loose| * #|T|.
Proof. by rewrite card_sum card_prod. Qed.

End Completion.

