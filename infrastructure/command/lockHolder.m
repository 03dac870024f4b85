% LOCKHOLDER  Which process works in a case folder, as its lock says.
%
% CALL: HOLDER = lockHolder (FOLDER)
%
%   FOLDER  case folder (text)
%   HOLDER  scalar struct: host (text, '' where there is no lock), pid, state:
%           'none'; 'alive'; 'gone' (the lock is what a killed Octave has
%           left); 'unknown' (another host)
%
% See also: lockCase, caseStatus, sayCancel

function holder = lockHolder (folder)
  holder = struct ('host', '', 'pid', NaN, 'state', 'none');
  fid = fopen (fullfile (folder, 'decalioc.lock'), 'r');
  if fid < 0
    return
  end
  words = strsplit (strtrim (fread (fid, Inf, 'uint8=>char')'));
  fclose (fid);
  if numel (words) ~= 3
    return
  end
  holder.host = words{1};
  holder.pid = str2double (words{2});
  if ~strcmp (holder.host, gethostname ())
    holder.state = 'unknown';
  elseif strcmp (processStart (holder.pid), words{3})
    holder.state = 'alive';
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
%! clear lock
%! file = fullfile (folder, 'decalioc.lock');
%! writeAtomic (file, sprintf ("%s 1 12345678901\n", gethostname ()));
%! assert (lockHolder (folder).state, 'gone');
%! writeAtomic (file, "elsewhere 1 12345678901\n");
%! assert (lockHolder (folder).state, 'unknown');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
