% LOCKHOLDER  Which process works in a case folder, as its lock says.
%
% CALL: HOLDER = lockHolder (FOLDER, NAME)
%
%   FOLDER  case folder (text)
%   NAME    file of the lock in it (default 'decalioc.lock')
%   HOLDER  scalar struct: text (of the lock), host ('' where there is no
%           lock), pid, state:
%           'none'; 'alive' (host, process, its start, boot and command agree);
%           'gone' (the lock is what a killed Octave or a power cut has left);
%           'unknown' (another host; or a process that may be the one of a
%           toolbox which did not yet note boot and command)
%
% A lock takes its name when it is whole, so an empty one is nobody's.

function holder = lockHolder (folder, name)
  if nargin < 2
    name = 'decalioc.lock';
  end
  holder = struct ('text', '', 'host', '', 'pid', NaN, 'state', 'none');
  fid = fopen (fullfile (folder, name), 'r');
  if fid < 0
    return
  end
  text = fread (fid, Inf, 'uint8=>char')';
  fclose (fid);
  holder.text = strtrim (text(text ~= 0));
  words = [strsplit(holder.text, ' '), {'', '', ''}];
  holder.host = words{1};
  holder.pid = str2double (words{2});
  [start, mark] = processStart (holder.pid);
  if isempty (holder.text)
    holder.state = 'gone';
  elseif ~strcmp (holder.host, gethostname ()) || isnan (holder.pid)
    holder.state = 'unknown';
  elseif strcmp (strjoin ([words(1:2), {mark}], ' '), holder.text)
    holder.state = 'alive';
  elseif numel (words) == 6 && strcmp (start, words{3})
    holder.state = 'unknown';
  else
    holder.state = 'gone';
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! assert (lockHolder (folder).state, 'none');
%! lock = lockCase (folder);
%! holder = lockHolder (folder);
%! assert ({holder.state, holder.pid}, {'alive', getpid()});
%! text = holder.text;
%! clear lock
%! file = fullfile (folder, 'decalioc.lock');
%! words = strsplit (text, ' ');
%! % before a restart, another program, an older toolbox, rubbish, cut power
%! for given = {strrep(text, words{4}, fliplr (words{4})), 'gone'; ...
%!              strrep(text, 'octave', 'mail'), 'gone'; ...
%!              strjoin([words(1:2), {'12345678901'}], ' '), 'gone'; ...
%!              strjoin(words(1:3), ' '), 'unknown'; ...
%!              'elsewhere 1 12345678901', 'unknown'; 'rubbish', 'unknown'; ...
%!              '', 'gone'; char(zeros (1, 40)), 'gone'}'
%!   writeAtomic (file, given{1});
%!   assert (strcmp (lockHolder (folder).state, given{2}), given{1});
%! end
