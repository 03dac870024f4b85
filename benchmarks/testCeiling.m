% TESTCEILING  How far apart the best test could bring two causes.
%
% CALL: octave-cli benchmarks/testCeiling.m CSV...
%
%   CSV  tables of nextTestStudy; of their withheld cases only the laboratory,
%        the true cause and what was said are read
%
% For each case the laws themselves are asked, without noise: the distance of
% the truth from the nearest single rival with its own parameters and strength
% (testDistance), in standard deviations of the whole noise, on the targets of
% the case, and the largest one that any of its tests, or any bench once more,
% adds to them. Two causes that are nearer than 2.5 with every test are told
% apart by none: the odds against the rival are exp (d^2 / 2) at the most, 20 at
% 2.5. Prints a row a case, and the shares of those that a test could tell.
%
% See also: nextTestStudy, testCase

1;

function sayCeiling (files)
  addpath (fileparts (mfilename ('fullpath')));
  startBenchmarks ();
  pkg ('load', 'stk');
  [most, right, once] = deal (zeros (1, 0));
  printf ('kind,number,truth,now,onceMore,bestTest,best\n');
  for file = files
    [header, cells] = readCsvTable (file{1});
    isOut = ismember (cells(:, strcmp (header, 'test')), ...
                      {'not withheld', 'too weak'});
    for row = cell2struct (cells(~isOut, :), header, 2)'
      [now, again, best, name] = reach (row.kind, str2double (row.number));
      printf ('%s,%s,%s,%.2f,%.2f,%s,%.2f\n', row.kind, row.number, ...
              row.truth, now, again, name, best);
      most(end + 1) = max (again, best);
      right(end + 1) = str2double (row.right);
      once(end + 1) = str2double (row.onceRight);
    end
  end
  sayShare ('a test could tell', most >= 2.5, true (size (most)));
  sayShare ('of these: the advised one named rightly', right > 0, most >= 2.5);
  sayShare ('of these: once more named rightly', once > 0, most >= 2.5);
  sayShare ('of the others: the advised one', right > 0, most < 2.5);
end

function [now, again, best, name] = reach (kind, number)
  [lab, twin] = testCase (kind, number);
  sd = sqrt (lab.noiseSd.^2 + lab.gapProblem.sd.^2);
  now = testDistance (lab.means, twin, sd);
  again = 0;
  bench = lab.gapProblem.bench;
  for b = 1:max (bench)
    half = sd;
    half(bench == b) = half(bench == b) / sqrt (2);
    again = max (again, testDistance (lab.means, twin, half));
  end
  [best, name] = deal (0, '');
  for test = lab.tests
    own = sqrt ((test.noise.^2 + test.sd.^2) / 3);
    d = testDistance (@(t, p) [lab.means(t, p), test.means(t, p)], twin, ...
                      [sd, own]);
    if d > best
      [best, name] = deal (d, test.model);
    end
  end
end

sayCeiling (argv ()');
