#!/usr/bin/python3
"""gaunt_ref.csv: i,j,k,value  real triple product coefficients below 6 bands, i <= j <= k, 20 digits, from exact rational
3j symbols (Racah's sum) and the unitary map from complex to real harmonics. Also prints counts to 10 bands and checks all
coefficients below 6 bands by quadrature. Needs python3-mpmath and python3-numpy.
"""
import os
D=os.path.dirname(os.path.abspath(__file__))
from fractions import Fraction as F
from math import factorial as fac, isqrt
import mpmath as mp, itertools, csv, sys
from functools import lru_cache
mp.mp.dps=40
@lru_cache(None)
def w3j2(j1,j2,j3,m1,m2,m3):
    """returns (sign, squared value) of Wigner 3j as rational"""
    if m1+m2+m3 or abs(m1)>j1 or abs(m2)>j2 or abs(m3)>j3 or j3<abs(j1-j2) or j3>j1+j2: return (0,F(0))
    s=F(0)
    for t in range(max(0,j2-j3-m1,j1-j3+m2),min(j1+j2-j3,j1-m1,j2+m2)+1):
        s+=F((-1)**t,fac(t)*fac(j3-j2+t+m1)*fac(j3-j1+t-m2)*fac(j1+j2-j3-t)*fac(j1-t-m1)*fac(j2-t+m2))
    if s==0: return (0,F(0))
    pre=F(fac(j1+j2-j3)*fac(j1-j2+j3)*fac(-j1+j2+j3),fac(j1+j2+j3+1))*fac(j1+m1)*fac(j1-m1)*fac(j2+m2)*fac(j2-m2)*fac(j3+m3)*fac(j3-m3)
    sg=(-1)**(j1-j2-m3)*(1 if s>0 else -1)
    return (sg,s*s*pre)
@lru_cache(None)
def cg2(l1,m1,l2,m2,l3,m3):
    """complex Gaunt int Y Y Y (CS phase) : sign, square*4pi"""
    a=w3j2(l1,l2,l3,0,0,0);b=w3j2(l1,l2,l3,m1,m2,m3)
    return (a[0]*b[0],a[1]*b[1]*(2*l1+1)*(2*l2+1)*(2*l3+1))
def cval(l1,m1,l2,m2,l3,m3):
    s,q=cg2(l1,m1,l2,m2,l3,m3)
    return s*mp.sqrt(mp.mpf(q.numerator)/q.denominator/(4*mp.pi)) if s else mp.mpf(0)
def U(m):
    """real Y_m (no CS) = sum_mu U[mu] Ycomplex_CS_mu ; list of (mu, coef)"""
    r=1/mp.sqrt(2)
    if m==0: return [(0,mp.mpc(1))]
    a=abs(m)
    if m>0: return [(a,mp.mpc((-1)**a*r)),(-a,mp.mpc(r))]      # sqrt2 K P cos
    return [(a,mp.mpc(0,-1)*(-1)**a*r),(-a,mp.mpc(0,1)*r)]      # sqrt2 K P sin
@lru_cache(None)
def rgaunt(l1,m1,l2,m2,l3,m3):
    t=mp.mpc(0)
    for a,ca in U(m1):
        for b,cb in U(m2):
            for c,cc in U(m3):
                if a+b+c==0: t+=ca*cb*cc*cval(l1,a,l2,b,l3,c)
    assert abs(t.imag)<mp.mpf(10)**-30
    return t.real if abs(t.real)>mp.mpf(10)**-30 else mp.mpf(0)
def lm(i): l=isqrt(i); return l,i-l*l-l
def allowed(l1,m1,l2,m2,l3,m3):
    if (l1+l2+l3)%2 or l3>l1+l2 or l3<abs(l1-l2): return False
    if sum(m<0 for m in (m1,m2,m3))%2: return False
    a,b,c=abs(m1),abs(m2),abs(m3)
    return a+b==c or b+c==a or a+c==b
if __name__=='__main__':
    print("n  n^6  selected  nonzero(all i,j,k)  unique(i<=j<=k)  accidental zeros  per-output min/max")
    N=10
    T={}
    for i in range(N*N):
        l1,m1=lm(i)
        for j in range(i,N*N):
            l2,m2=lm(j)
            for k in range(j,N*N):
                l3,m3=lm(k)
                if l3>l1+l2 or (l1+l2+l3)%2: continue
                if allowed(l1,m1,l2,m2,l3,m3): T[i,j,k]=rgaunt(l1,m1,l2,m2,l3,m3)
    for n in range(2,N+1):
        sel=0;nz=0;uq=0;acc=0;per=[0]*(n*n); uqw=0
        for (i,j,k),v in T.items():
            if k>=n*n: continue
            mult=len(set(itertools.permutations((i,j,k))))
            sel+=mult
            if v==0: acc+=mult; continue
            uq+=1;nz+=mult
            for p in set(itertools.permutations((i,j,k))): per[p[2]]+=1
        print(n,n**6,sel,nz,uq,acc,min(per),max(per), "per k n=3/4:" if n in(3,4) else '', per if n in (3,4) else '')
    w=csv.writer(open(os.path.join(D,'gaunt_ref.csv'),'w')); w.writerow(['i','j','k','value'])
    cnt=0
    for (i,j,k),v in sorted(T.items()):
        if k<36 and v!=0: w.writerow([i,j,k,mp.nstr(v,20,strip_zeros=False,min_fixed=0,max_fixed=0)]); cnt+=1
    print("gaunt_ref rows (i<=j<=k)",cnt)
    print("accidental zeros first:",[ (lm(i),lm(j),lm(k)) for (i,j,k),v in sorted(T.items()) if v==0][:8])
    # selection rule completeness: brute force check forbidden ones vanish (n=4) using quadrature in double
    import numpy as np
    from shlib import sh_eval
    n=6; xs,ws=np.polynomial.legendre.leggauss(10); nph=20
    Y=[];W=[]
    for x,w in zip(xs,ws):
        for q in range(nph):
            ph=2*np.pi*q/nph; s=np.sqrt(1-x*x)
            Y.append([float(t) for t in sh_eval(n,mp.mpf(s*np.cos(ph)),mp.mpf(s*np.sin(ph)),mp.mpf(x))]); W.append(w*2*np.pi/nph)
    Y=np.array(Y);W=np.array(W)
    G=np.einsum('q,qi,qj,qk->ijk',W,Y,Y,Y)
    worst=0;forb=0
    for i in range(n*n):
        for j in range(i,n*n):
            for k in range(j,n*n):
                v=float(T.get((i,j,k),0)); worst=max(worst,abs(v-G[i,j,k]))
    print("vs quadrature n=6 max diff",worst)
