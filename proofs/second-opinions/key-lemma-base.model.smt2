; A model of the hypotheses of key-lemma-base.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. The marker points to a0.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((Turn 0)) (((zero) (one))))
(define-fun turn ((x0 Turn) (x1 Dart)) Dart
  (ite (and (= x0 one) (= x1 a0)) a1 (ite (and (= x0 one) (= x1 a1)) a0
  (ite (and (= x0 one) (= x1 b0)) b1 (ite (and (= x0 one) (= x1 b1)) b0
  (ite (and (= x0 one) (= x1 c0)) c1 (ite (and (= x0 one) (= x1 c1)) c0 x1)))))))
(define-fun unturn ((x0 Turn) (x1 Dart)) Dart
  (ite (and (= x0 one) (= x1 a0)) a1 (ite (and (= x0 one) (= x1 a1)) a0
  (ite (and (= x0 one) (= x1 b0)) b1 (ite (and (= x0 one) (= x1 b1)) b0
  (ite (and (= x0 one) (= x1 c0)) c1 (ite (and (= x0 one) (= x1 c1)) c0 x1)))))))
(define-fun home ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun bearing ((x Dart)) Turn (ite (= x a1) one zero))
(define-fun pointed () Dart a0)
(define-fun x () Dart a1)
(define-fun y () Dart a1)

(assert (forall ((b Turn) (d Dart)) (= (unturn b (turn b d)) d)))
(assert (forall ((d Dart)) (=> (home d) (= (turn (bearing d) d) pointed))))
(assert (home x))
(assert (home y))
(assert (= (bearing x) (bearing y)))
(check-sat)
