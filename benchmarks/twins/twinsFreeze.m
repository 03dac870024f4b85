% TWINSFREEZE  Writes truth, its digest and the observables before any scoring.
%
% CALL: DIGEST = twinsFreeze (NAME, TWINS, LABS)
%
%   NAME    path without ending; NAME-truth.csv, NAME-truth.sha256 and
%           NAME-cases.csv are written
%   TWINS   of twinsDraw;  LABS  of foreignLaboratories
%   DIGEST  text, SHA-256 of the truth file
%
% A study that draws look-alikes has three columns more: the effect that is
% resembled, the cosine, and the signature that no list holds.
%
% See also: foreignTwins

function digest = twinsFreeze (name, twins, labs)
  id = fopen ([name, '-truth.csv'], 'w');
  isRich = any ([twins.like]);
  fprintf (id, 'case,lab,class,cause,removed,d,theta,phi%s\n', ...
           repmat (',like,cosine,alien', 1, isRich));
  for i = 1:numel (twins)
    t = twins(i);
    fprintf (id, '%d,%s,%s,%s,%d,%.6g,%s,%s', i, labs(t.lab).name, ...
             t.class, strtrim (sprintf ('%d ', t.cause)), t.removed, t.d, ...
             strtrim (sprintf ('%.6g ', t.theta)), ...
             strtrim (sprintf ('%.6g ', t.phi)));
    if isRich
      fprintf (id, ',%d,%g,%s', t.like, t.cosine, ...
               strtrim (sprintf ('%.6g ', t.alien)));
    end
    fputs (id, "\n");
  end
  fclose (id);
  digest = hash ('sha256', fileread ([name, '-truth.csv']));
  id = fopen ([name, '-truth.sha256'], 'w');
  [~, stem] = fileparts (name);
  fprintf (id, '%s  %s-truth.csv\n', digest, stem);
  fclose (id);
  id = fopen ([name, '-cases.csv'], 'w');
  fprintf (id, 'case,lab,removed,y\n');
  for i = 1:numel (twins)
    t = twins(i);
    fprintf (id, '%d,%s,%d,%s\n', i, labs(t.lab).name, t.removed, ...
             strtrim (sprintf ('%.10g ', t.y)));
  end
  fclose (id);
end

%!test % the digest is that of the file, the look-alike is in it
%! name = tempname ();
%! labs.name = 'here';
%! twins = struct ('lab', 1, 'class', 'look', 'cause', 0, 'removed', 0, ...
%!                 'd', 3, 'theta', 0.5, 'phi', [0, 0], 'like', 2, ...
%!                 'cosine', 0.7, 'alien', [1, 2], 'y', [5, 6]);
%! digest = twinsFreeze (name, twins, labs);
%! truth = fileread ([name, '-truth.csv']);
%! cases = fileread ([name, '-cases.csv']);
%! kept = fileread ([name, '-truth.sha256']);
%! delete ([name, '-truth.csv'], [name, '-cases.csv'], ...
%!         [name, '-truth.sha256']);
%! assert (digest, hash ('sha256', truth));
%! assert (strncmp (kept, digest, 64));
%! assert (~isempty (strfind (truth, '1,here,look,0,0,3,0.5,0 0,2,0.7,1 2')));
%! assert (cases, "case,lab,removed,y\n1,here,0,5 6\n");
