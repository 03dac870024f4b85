% READINDEX  Reads the index of the runs of a model, see readLibrary.
%
% CALL: [KINDS, MARKS] = readIndex (FILE)
%
%   FILE   path (text)
%   KINDS  see readLibrary;  MARKS  n x 3: number of a run, size and time (s) of
%          the record that the index has read
%
% Nothing is known, and the records are read, where the file is missing, torn or
% of another form; or of another user, or one that others can write to: what it
% hides would be missing, and nobody would tell.
%
% The file: its sha256, a line of JSON, then all numbers as 8 bytes each. None
% of it is ever evaluated, as Octave's load would do with a function handle.

function [kinds, marks] = readIndex (file)
  marks = zeros (0, 3);
  kinds = struct ('input', {}, 'funs', {}, 'origin', {}, 'owner', {}, ...
                  'names', {}, 'runs', {});
  if ~isOurs (file)
    return
  end
  try
    [head, numbers, isWhole] = parts (file);
    if isWhole
      [kinds, marks] = cut (head, numbers, kinds, marks);
    end
  catch
    % none that writeIndex has written
  end
end

function yes = isOurs (file)
  s = stat (file);
  yes = ~isempty (s) && s.uid == geteuid () && ~any (s.modestr([6, 9]) == 'w');
end

function [head, numbers, isWhole] = parts (file)
  fid = fopen (file, 'r');
  bytes = fread (fid, Inf, 'uint8=>uint8')';
  fclose (fid);
  ends = find (bytes == 10, 2);
  isWhole = strcmp (char (bytes(1:ends(1) - 1)), ...
                    hash ('sha256', char (bytes(ends(1) + 1:end))));
  head = jsondecode (char (bytes(ends(1) + 1:ends(2) - 1)));
  numbers = typecast (bytes(ends(2) + 1:end), 'double');
end

% The matrices one after the other, as writeIndex put them.
function [kinds, marks] = cut (head, numbers, kinds, marks)
  list = head.kinds;
  sizes = [head.marks, 3];
  if ~isempty (list)
    sizes = [sizes; vertcat(list.rows), vertcat(list.columns)];
  end
  last = cumsum (prod (sizes, 2));
  if last(end) ~= numel (numbers) || head.form ~= 1 || ~isSane (list)
    return
  end
  first = [1; last(1:end - 1) + 1];
  part = @(k) reshape (numbers(first(k):last(k)), sizes(k, :));
  marks = part (1);
  for k = 1:numel (list)
    for name = {'input', 'funs', 'origin', 'owner', 'names'}
      kinds(k).(name{1}) = list(k).(name{1});
    end
    kinds(k).runs = part (k + 1);
  end
end

% Of each kind the texts, and columns for its variables and a result.
function yes = isSane (list)
  yes = true;
  for kind = list(:)'
    texts = {kind.input, kind.funs, kind.origin, kind.owner, kind.names};
    yes = yes && all (cellfun ('isclass', texts, 'char')) && ...
          kind.columns >= 7 + sum (kind.names == ' ');
  end
end

%!shared kinds, marks, file
%! place = ["/", char([195, 164]), " b\n"];
%! kinds = struct ('input', {'a', 'b'}, 'funs', 'f', 'origin', place, ...
%!                 'owner', '', 'names', 'a runSeed', ...
%!                 'runs', {magic(9), zeros(0, 8)});
%! marks = [1, 2, 3; 4, 5, 1e9 / 3];
%! file = tempname ();
%!test
%! for k = [2, 1, 0]
%!   writeIndex (file, kinds(1:k), marks);
%!   [back, known] = readIndex (file);
%!   assert (isequal (back(:), kinds(1:k)(:)));
%!   assert (known, marks);
%! end
%!test
%! % torn, changed, of others, of another form
%! writeIndex (file, kinds, marks);
%! assert (strtrim (stat (file).modestr), '-rw-------');
%! whole = fileread (file);
%! bad = {'', 'x', "x\n\n", whole(1:end - 1), [whole, 'x'], ...
%!        strrep(whole, '/', '\'), strrep(whole, '"rows":9', '"rows":8'), ...
%!        "# Created by Octave\n# name: kinds\n# type: scalar\n1\n"};
%! for k = 1:numel (bad)
%!   fid = fopen (file, 'w');
%!   fwrite (fid, bad{k});
%!   fclose (fid);
%!   [back, known] = readIndex (file);
%!   assert ({size(back), known}, {[0, 0], zeros(0, 3)});
%! end
%! % of the right sum, but of another form
%! bad = {'runs', magic(3), 'origin', 5, 'runs', zeros(0, 0), 'names', 1};
%! for k = 1:2:numel (bad)
%!   writeIndex (file, setfield (kinds(1), bad{k:k + 1}), marks);
%!   assert (isempty (readIndex (file)));
%! end
%! writeIndex (file, kinds, marks);
%! system (['chmod g+w ', file]);
%! assert (isempty (readIndex (file)));
%! for head = {'{"form":1,"marks":2,"kinds":5}', '{"form":2}', '[]', '{', ...
%!             '{"form":1,"marks":-2,"kinds":[]}'}
%!   rest = [head{1}, "\n", repmat("a", 1, 48)];
%!   fid = fopen (file, 'w');
%!   fwrite (fid, [hash('sha256', rest), "\n", rest]);
%!   fclose (fid);
%!   system (['chmod 600 ', file]);
%!   assert (isempty (readIndex (file)));
%! end
%!assert (isempty (readIndex ('/nowhere')))

% SPDX-License-Identifier: GPL-3.0-only
