/* PARI/GP. Started as: gp -q -f WORK/prelude.gp pari.gp, where the prelude sets job, work and cases.
   Tried: J3 sqrtn(10, 8) (slower than three square roots); J5 polrootsreal and polsturm (counts are the faster), and
   the coefficients; J6 prod and a fold (quadratic) against vecprod (a product tree). */

modulus = 2^127 - 1;
wanted(name) = #cases == 0 || #select(c -> c == name, cases) > 0;

/* The time of one call in seconds, and its value; the clock ticks in milliseconds, so short calls are repeated. */
measure(f) =
{
  my(begin = getwalltime(), value = f(), once = getwalltime() - begin, calls = 1, spent = once);
  while(spent < 100 && once < 20,
    calls *= 4;
    begin = getwalltime();
    for(i = 1, calls, f());
    spent = getwalltime() - begin);
  [spent / 1000. / calls, value];
}

report(name, f, answer) =
{
  if(!wanted(name), return);
  my(found = measure(f));
  printf("{\"case\": \"%s\", \"seconds\": %de-12, \"answer\": \"%s\"}\n", name, round(found[1]*1e12), answer(found[2]));
}

eta2(m1, m2, e) = (1 + e)^2*m1*m2/(m1 + m2)^2;
eta3(m1, m2, mu, e1, e2) = (1 + e1)^2*(1 + e2)^2*m1*m2*mu^2/((m1 + mu)^2*(mu + m2)^2);
share(masses, es) = masses[#masses]/masses[1]*prod(i = 1, #es, masses[i]*(1 + es[i])/(masses[i] + masses[i + 1]))^2;
after(a, b, e, v, w) = [((a - e*b)*v + b*(1 + e)*w)/(a + b), (a*(1 + e)*v + (b - e*a)*w)/(a + b)];
laws(a, b, e, v, w) = my(t = after(a, b, e, v, w)); a*v + b*w == a*t[1] + b*t[2] && t[2] - t[1] == -e*(w - v);
bracket(m1, m2, t) = (m1*m2 - 3*t^2)*(m1 + t)*(t + m2) - 3*t*(m1*m2 - t^2)*(m1 + m2 + 2*t);

/* The same list as in identities.py, with the same variables for powers and roots. */
identities() =
{
  my(x1 = 'm1/'m2, r = 'x*(1 + 'e)/('x + 1), w, k, s, formula);
  if(!laws('m1, 'm2, 'e, 'v1, 'v2) || !laws('m1, 'mu, 'e1, 'v1, 'v2), return(0));
  if([(('m1/'m2 - 'e)*'v1 + (1 + 'e)*'v2)/(x1 + 1), (x1*(1 + 'e)*'v1 + (1 - 'e*x1)*'v2)/(x1 + 1)]
    != after('m1, 'm2, 'e, 'v1, 'v2), return(0));
  if(share(['m1, 'm2], ['e]) != eta2('m1, 'm2, 'e), return(0));
  if(eta2('m1, 'm2, 'e) != (1 + 'e)^2*x1/(1 + x1)^2, return(0));
  w = 'mu*(1 + 'e2)/('mu + 'm2)*'m1*(1 + 'e1)/('m1 + 'mu)*'v1;
  if(w != (1 + 'e1)*(1 + 'e2)*'m1*'mu/(('m1 + 'mu)*('mu + 'm2))*'v1, return(0));
  if('m2*w^2 != eta3('m1, 'm2, 'mu, 'e1, 'e2)*'m1*'v1^2, return(0));
  if(share(['m1, 'mu, 'm2], ['e1, 'e2]) != eta3('m1, 'm2, 'mu, 'e1, 'e2), return(0));
  if(share(['m1, 'mu1, 'mu2, 'm2], ['e1, 'e2, 'e3]) != (1 + 'e1)^2*(1 + 'e2)^2*(1 + 'e3)^2*'m1*'m2*'mu1^2*'mu2^2
    /(('m1 + 'mu1)^2*('mu1 + 'mu2)^2*('mu2 + 'm2)^2), return(0));
  formula = (up, down) -> up*('x - 'e)/(down*('x + 1));
  if(('x - 'e)/('x + 1) != formula(1, 1), return(0));
  if(r*formula('p, 'g) != formula('p*'x*(1 + 'e), 'g*('x + 1)), return(0));
  if(('m1 - 'e*'mu1)/('m1 + 'mu1)*'v1 != ('m1/'mu1 - 'e)/('m1/'mu1 + 1)*'v1, return(0));
  if(r*('p*r*'v1) != 'p*r^2*'v1, return(0));
  if('h/'g*('g/'h*(1 + 'e)/('g/'h + 1))^2 != (1 + 'e)^2*'g*'h/('g + 'h)^2, return(0));
  if('m2*('m1*(1 + 'e)/('m1 + 'm2)*'v1)^2 != eta2('m1, 'm2, 'e)*'m1*'v1^2, return(0));
  s = deriv((1 + 'e)^2*'x/(1 + 'x)^2, 'x);
  if(s != (1 + 'e)^2*((1 + 'x)^2 - 2*'x*(1 + 'x))/(1 + 'x)^4 || s != (1 + 'e)^2*(1 - 'x)/(1 + 'x)^3, return(0));
  k = 2*(1 + 'e1)^2*(1 + 'e2)^2*'m1*'m2;
  s = deriv(eta3('m1, 'm2, 'mu, 'e1, 'e2), 'mu);
  if(s != k*'mu*(('m1 + 'mu)*('mu + 'm2) - 'mu*('m1 + 'm2 + 2*'mu))/(('m1 + 'mu)^3*('mu + 'm2)^3), return(0));
  if(s != k*'mu*('m1*'m2 - 'mu^2)/(('m1 + 'mu)^3*('mu + 'm2)^3), return(0));
  if(deriv(s, 'mu) != k*bracket('m1, 'm2, 'mu)/(('m1 + 'mu)^4*('mu + 'm2)^4), return(0));
  if(bracket('g^2, 'h^2, 'g*'h) != -2*'g^3*'h^3*('g + 'h)^2, return(0));
  16*'g^2*'h^2/('g + 'h)^4/(4*'g^2*'h^2/('g^2 + 'h^2)^2) == 4*('g^2 + 'h^2)^2/('g + 'h)^4;
}

digits_job() =
{
  my(floor_of = (x, n) -> lift(Mod(floor(x*10^(n - 10)), modulus)));
  my(sizes = [100, 150, 200, 600, 1000, 10000, 100000, 1000000]);
  for(k = 1, #sizes, my(n = sizes[k]);
    localbitprec(ceil(n*3.3219280948874) + 64);
    report(Str("eta/", n), () -> my(t = sqrt(sqrt(sqrt(10.)))); (361*t/(1 + t)^2/100)^8, x -> floor_of(x, n));
    report(Str("L_7/", n), () -> (1 + sqrt(sqrt(sqrt(10.))))^8/(1 + sqrtn(10., 7))^7 - 1, x -> floor_of(x, n)));
}

/* Exact where r is a perfect power; otherwise a difference of 200 bits, uncertified. */
sign_of(n, e, r) =
{
  my(t);
  if(ispower(r, n*(n + 1), &t), return(sign(1 + e - (1 + t^n)^(n + 1)/(1 + t^(n + 1))^n)));
  localbitprec(200);
  sign(1 + e - (1 + sqrtn(r*1., n + 1))^(n + 1)/(1 + sqrtn(r*1., n))^n);
}

signs() =
{
  foreach(readstr(Str(work, "/J4.txt")), line, my(w = strsplit(line, " "));
    my(n = eval(w[2]), e = eval(w[3]), r = eval(w[4]));
    report(w[1], () -> sign_of(n, e, r), s -> s));
}

/* (A_n·A_(n+2) − A_(n+1)²)/(y^k·(y − 1)²) */
quotient(n) =
{
  my(l = lcm([n, n + 1, n + 2]), a = k -> (1 + 'y^(l/k))^k, p = a(n)*a(n + 2) - a(n + 1)^2);
  p /= 'y^valuation(p, 'y);
  my(q = divrem(p, ('y - 1)^2));
  if(q[2] != 0, error("not divisible"));
  q[1];
}

growth(decide) = for(n = 1, 24, report(Str(n), () -> decide(quotient(n)), t -> if(t, "true", "false")));
by_roots(q) = subst(q, 'y, 1) > 0 && polsturm(q/gcd(q, q'), [0, oo]) == 0;
by_coefficients(q) = vecmin(Vec(q)) >= 0;

long_chains() =
{
  my(rows = n -> [eval(concat(["[", strjoin(strsplit(line, " "), ","), "]"])) | line <- readstr(Str(work, "/J6-", n, ".txt"))]);
  my(all = rows(1000), m = [r[1]/r[2] | r <- all], e = [r[3]/r[4] | r <- all]);
  my(everyone = () -> my(v = 1, out = vector(#m));
    for(i = 1, #m - 1, my(s = m[i] + m[i + 1]);
      out[i] = (m[i] - e[i + 1]*m[i + 1])/s*v; v = m[i]*(1 + e[i + 1])/s*v);
    out[#m] = v; out);
  report("all/1000", everyone, v -> sum(i = 1, #v, i*(numerator(v[i]) + 3*denominator(v[i]))) % modulus);
  for(k = 2, 6, my(n = 10^k);
    if(!wanted(Str("last/", n)), next);
    my(r = rows(n), last);
    last = (() -> vecprod(vector(n - 1, i, my(x = r[i], y = r[i + 1]); x[1]*y[2]*(y[3] + y[4])))
      /vecprod(vector(n - 1, i, my(x = r[i], y = r[i + 1]); (x[1]*y[2] + x[2]*y[1])*y[4])));
    report(Str("last/", n), last, v -> Str(numerator(v) % modulus, "/", denominator(v) % modulus)));
}

/* Uncertified: L_n in 160 bits on both sides of the guess. */
best(r, e) =
{
  localbitprec(192);
  my(c = log(2/(1. + e)), u = sqrt(2*c), n, l = log(r*1.));
  for(i = 1, 60, my(step = (c - u*tanh(u) + log(cosh(u)))*cosh(u)^2/u); u += step; if(abs(step) < 1e-30, break));
  n = floor(l/2/u - 1/2);
  my(helps = n -> 2*((1 + exp(l/(n + 1)))/2)^(n + 1)/((1 + exp(l/n))/2)^n - 1 <= e);
  while(!helps(n), n--);
  while(helps(n + 1), n++);
  n;
}

best_numbers() =
{
  foreach(readstr(Str(work, "/J7.txt")), line, my(w = strsplit(line, " "));
    my(r = eval(w[2]), e = eval(w[3]));
    report(w[1], () -> best(r, e), n -> n));
}

if(job == "J1", report("19 identities", identities, ok -> if(ok, "true", "false")));
if(job == "J3", digits_job());
if(job == "J4", signs());
if(job == "J5", growth(by_coefficients));
if(job == "J5-sturm", growth(by_roots));
if(job == "J6", long_chains());
if(job == "J7", best_numbers());
quit
