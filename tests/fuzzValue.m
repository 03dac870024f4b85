% FUZZVALUE  Makes a random value of any kind that Octave knows.
%
% CALL: VALUE = fuzzValue (DEPTH, CANARY)
%
%   DEPTH   how deep it is nested already; below 3 it may nest again
%   CANARY  path of a file that texts try to make when they are run
%   VALUE   anything
%
% See also: fuzzInput

function value = fuzzValue (depth, canary)
  makers = {@() texts(canary), @numbers, @arrays, @odd};
  if depth < 3
    makers{end + 1} = @() nested (depth + 1, canary);
  end
  make = pick (makers);
  value = make ();
end

function value = pick (values)
  k = ceil (numel (values) * rand ());
  value = values{k};
end

function value = texts (canary)
  value = pick ({'', 'a', 'Toy', 'densityP', 'local', 'slurm', ...
                 ['$(touch ', canary, ')'], ['''; touch ', canary, '; '''], ...
                 ['`touch ', canary, '`'], ...
                 ['system (''touch ', canary, ''')'], "two\nlines", ...
                 'it''s "quoted"', char(0:31), char(128:255), ...
                 repmat('x', 1, 5000), ['ab'; 'cd'], '../../etc', '%s%n%d', ...
                 char(zeros (0, 3)), char([240, 159, 166, 128])});
end

function value = numbers ()
  value = pick ({0, 1, -1, 2.5, NaN, Inf, -Inf, NA, 1e308, -0, eps, 1i, ...
                 int8(5), uint64(18446744073709551615), single(0.1), true, ...
                 false, int32(0), 21, 1e6, 2^53});
end

function value = arrays ()
  value = pick ({[], zeros(0, 3), zeros(3, 0), 1:3, (1:3)', 1:0, ...
                 ones(2, 2, 2), sparse(2), sparse([1, 0, 2]), ...
                 sparse(0, 0), eye(3), [1, NaN], [0.01; 0.01], ...
                 complex(1:2, 3:4), true(1, 3), 0:0.1:0.3, rand(2, 5), ...
                 uint8(1:4), single([1, 2; 3, 4]), randn(1, 200), ...
                 zeros(2, 0, 3)});
end

function value = odd ()
  value = pick ({@sin, @(x) x + 1, {}, struct(), struct('a', {}), ...
                 struct('a', {1, 2}), containers.Map(), cell(2, 3), ...
                 cell(0, 2), struct('name', 'tilt'), inputParser(), ...
                 struct('name', {'tilt', 'drag'}), {[], []}, {''}, {{}}});
end

function value = nested (depth, canary)
  n = floor (4 * rand ());
  if rand () < 0.6
    value = cell (1, n);
    for k = 1:n
      value{k} = fuzzValue (depth, canary);
    end
    if rand () < 0.3
      value = value.';
    end
  else
    value = struct ();
    names = {'name', 'model', 'cpu', 'variables', 'neutral', 'limits', ...
             'x', 'laboratory', 'time', 'extra'};
    for k = 1:n
      value.(pick (names)) = fuzzValue (depth, canary);
    end
  end
end

%!test
%! rand ('twister', 1);
%! for k = 1:50
%!   assert (ischar (describeValue (fuzzValue (0, 'x'))));
%! end

% SPDX-License-Identifier: GPL-3.0-only
