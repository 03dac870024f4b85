% FUZZSEEDS  Tries a fuzzer on many seeds and prints what goes wrong.
%
% CALL: [FAILURES, COUNT] = fuzzSeeds (NAME, SEEDS, TRYONE, COUNT)
%
%   NAME      of the fuzzer, for the message (text)
%   SEEDS     1 x n integers, one problem each
%   TRYONE    handle, [FOUND, COUNT] = tryOne (SEED, COUNT): 1 x m cell of texts
%             on what went wrong, and the counts so far
%   COUNT     scalar struct of numbers
%   FAILURES  1 x m cell of texts, one a failure, with its seed
%
% See also: fuzzDiagnoses, fuzzCalibrations

function [failures, count] = fuzzSeeds (name, seeds, tryOne, count)
  failures = {};
  for seed = seeds
    [found, count] = tryOne (seed, count);
    for text = found
      failures{end + 1} = sprintf ('%s (%d): %s', name, seed, text{1});
      printf ('%s\n', failures{end});
    end
    fflush (stdout ());
  end
  words = [fieldnames(count), struct2cell(count)]';
  printf ('%s: %d failures; %s\n', name, numel (failures), ...
          strtrim (sprintf ('%s %d  ', words{:})));
end

%!function [found, count] = oddOnes (seed, count)
%!  found = repmat ({'odd'}, 1, mod (seed, 2));
%!  count.tried = count.tried + 1;
%!endfunction
%!test
%! evalc (['[failures, count] = fuzzSeeds (''it'', 1:3, @oddOnes, ', ...
%!         'struct (''tried'', 0));']);
%! assert (failures, {'it (1): odd', 'it (3): odd'});
%! assert (count.tried, 3);

% SPDX-License-Identifier: GPL-3.0-only
